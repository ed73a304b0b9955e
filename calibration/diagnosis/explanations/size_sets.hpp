// Alternative sets of parameter values of an effect, between which the measurements cannot decide.
#pragma once

#include "calibration/diagnosis/explanations/explanation.hpp"
#include "calibration/estimation/fitted_basis.hpp"

namespace tubeplan::calibration {

/// Searches for other parameter values of each effect of an explanation that explain the measurements equally well. If
/// any exist, the sets of values become the `modes` of the effect, most probable first. The parameters of the
/// explanation take the values of the first mode, and their ranges cover all modes. Throws WorkStopped on a request to
/// stop.
void findSizeSets(const FittedBasis& basis, Explanation& explanation);

}  // namespace tubeplan::calibration
