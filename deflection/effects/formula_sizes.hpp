// Search for the sizes among a formula's parameters: the largest set in which it is linear and without which it
// vanishes.
#pragma once

#include "deflection/effects/formula.hpp"

namespace tubeplan::deflection {

/// Returns the sizes as a bit mask: bit k for parameter k. Of several sets of that many, it is the one named first. The
/// search evaluates the expression at two dozen points; a formula without a value at any of them has no sizes.
[[nodiscard]] unsigned findSizes(const Formula& formula);

}  // namespace tubeplan::deflection
