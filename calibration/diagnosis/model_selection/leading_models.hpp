// Leading models among the competing ones, with the evidence of each linearised about its own fit.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Fits the leading models and the model with nothing missing, and computes their evidence about the fits. Throws
/// WorkStopped on a request to stop.
void fitLeaders(DiagnosisWork& work);

/// Returns the fitted model with exactly these effects. The fit starts from the parameters that the linear evidence
/// suggests and, if the effects are not neutral, again from their values; the most probable result is kept. The model
/// has no fit if one of the effects is not among the causes.
[[nodiscard]] CompetingModel fittedModelOf(const DiagnosisWork& work, const std::vector<deflection::Effect>& effects);

/// Returns the largest difference in log weight from the best model at which a model is still fitted. It allows for the
/// error of linearised evidence. `best` and `nothing` are the log weights of the best model and of the model with
/// nothing missing.
[[nodiscard]] double leaderWindow(double best, double nothing);

}  // namespace tubeplan::calibration
