// A competing model fitted with everything that is free, and its evidence about that fit.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

inline constexpr double kFoundSigmas = 2;  ///< of a fitted size, below which it may be none

/// Fills the model's fit and takes its evidence anew; a model that cannot be fitted has none. Unwinds where it was
/// stopped.
void fitModel(const DiagnosisWork& work, CompetingModel& model);

}  // namespace tubeplan::calibration
