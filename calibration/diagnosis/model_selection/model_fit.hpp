// Fit of a competing model with everything that is free, and its evidence about that fit.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

inline constexpr double kFoundSigmas = 2;  ///< least fitted size in standard deviations; a smaller one may be zero

/// Fits the model and recomputes its evidence; a model that cannot be fitted has none. Throws WorkStopped on a request
/// to stop.
void fitModel(const DiagnosisWork& work, CompetingModel& model);

}  // namespace tubeplan::calibration
