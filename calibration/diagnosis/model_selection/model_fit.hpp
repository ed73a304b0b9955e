// Fit of a competing model together with all free parameters, and the model's evidence, linearised about this fit.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Fits the model and recomputes its evidence, which is zero if the model cannot be fitted. Throws WorkStopped on a
/// request to stop.
void fitModel(const DiagnosisWork& work, CompetingModel& model);

}  // namespace tubeplan::calibration
