// Which parameters of a formula are its sizes: the largest set in which it is linear and without which it is nothing.
#pragma once

#include "deflection/effects/formula.hpp"

namespace tubeplan::deflection {

/// Bit k is set for parameter k; of several sets of that many the one that is named first. Found by trying the
/// expression at two dozen places; where it has a value at none of them it has no sizes.
[[nodiscard]] unsigned findSizes(const Formula& formula);

}  // namespace tubeplan::deflection
