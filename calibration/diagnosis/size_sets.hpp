// Whether the readings say which sizes an effect has, or only that they are among several.
//
// Readings of steps, or of a distance, do not say on which side the tip is. The likelihood of an effect that moves it is
// then a ring, or has several minima, and a fit stops at one of them. The sizes are looked for in every direction anew:
// where others explain the readings as well, the answer is the set of them.
#pragma once

#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/estimation/fitted_basis.hpp"

namespace tubeplan::calibration {

/// Looks for other sizes of each effect of an explanation. Where there are some, the effect has them as `modes`, the most
/// probable in front and in the explanation, and its numbers have ranges over all of them. Unwinds where it was stopped.
void findSizeSets(const FittedBasis& basis, Explanation& explanation);

}  // namespace tubeplan::calibration
