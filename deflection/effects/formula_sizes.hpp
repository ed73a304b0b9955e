// Search for a formula's sizes: the largest set of its parameters in which the formula is linear and that make it
// vanish if they are all zero.
#pragma once

#include "deflection/effects/formula.hpp"

namespace tubeplan::deflection {

/// Returns the sizes as a bit mask: bit k for parameter k. Among several largest sets, the one with the smallest mask
/// is returned. The search evaluates the expression at two dozen points; a formula that has a finite value at none of
/// them has no sizes.
[[nodiscard]] unsigned findSizes(const Formula& formula);

}  // namespace tubeplan::deflection
