// Leading models among the competing ones, with evidence about separate fits.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Fits the leading models and the model with nothing missing. Throws WorkStopped on a request to stop.
void fitLeaders(DiagnosisWork& work);

/// Returns the fitted model with exactly these effects. The fit starts from the sizes of the linear evidence and, if
/// the effects are not neutral, also from their values; the most probable result is kept. The model has no fit if one
/// of the effects is not among the causes.
[[nodiscard]] CompetingModel fittedModelOf(const DiagnosisWork& work, const std::vector<deflection::Effect>& effects);

/// Returns the distance in log weight from the best model within which linear evidence may be wrong. Models within this
/// distance are fitted.
[[nodiscard]] double leaderWindow(double best, double nothing);

}  // namespace tubeplan::calibration
