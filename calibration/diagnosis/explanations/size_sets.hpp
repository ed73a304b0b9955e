// The sizes of the effects of an explanation where readings say only that they are among several.
#pragma once

#include "calibration/diagnosis/explanations/explanation.hpp"
#include "calibration/estimation/fitted_basis.hpp"

namespace tubeplan::calibration {

/// Looks for other sizes of each effect of an explanation. Where there are some, the effect has them as `modes`, the
/// most probable in front and in the explanation, and its numbers have ranges over all of them. Unwinds where it was
/// stopped.
void findSizeSets(const FittedBasis& basis, Explanation& explanation);

}  // namespace tubeplan::calibration
