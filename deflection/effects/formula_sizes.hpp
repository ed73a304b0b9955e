// Search for the sizes among a formula's parameters: the largest set of parameters in which the formula is linear, and
// without which it vanishes.
#pragma once

#include "deflection/effects/formula.hpp"

namespace tubeplan::deflection {

/// Returns the sizes as a bit mask: bit k for parameter k. Among several largest sets, the set named first is returned.
/// The search evaluates the expression at two dozen points; a formula without a value at any of them has no sizes.
[[nodiscard]] unsigned findSizes(const Formula& formula);

}  // namespace tubeplan::deflection
