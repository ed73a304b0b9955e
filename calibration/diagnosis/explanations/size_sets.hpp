// Sets of effect sizes of an explanation that the readings cannot decide between.
#pragma once

#include "calibration/diagnosis/explanations/explanation.hpp"
#include "calibration/estimation/fitted_basis.hpp"

namespace tubeplan::calibration {

/// Searches for other sizes of each effect of an explanation that explain the readings equally well. If there are some,
/// they become the effect's `modes`, most probable first, the first is put into the explanation, and the numbers get
/// ranges over all modes. Throws WorkStopped on a request to stop.
void findSizeSets(const FittedBasis& basis, Explanation& explanation);

}  // namespace tubeplan::calibration
