// Leaders among the competing models, with evidence about separate fits.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Fits the leading models and that of nothing missing. Throws WorkStopped on a request to stop.
void fitLeaders(DiagnosisWork& work);

/// Returns the model of these effects with all their numbers. It is fitted from the sizes of the linear evidence and,
/// if the effects are not neutral, also from their values; the more probable result is kept. It has no fit if one of
/// the effects is no cause.
[[nodiscard]] CompetingModel fittedModelOf(const DiagnosisWork& work, const std::vector<deflection::Effect>& effects);

/// Returns the distance in log weight from the best model within which linear evidence may be wrong; models within it
/// are fitted.
[[nodiscard]] double leaderWindow(double best, double nothing);

}  // namespace tubeplan::calibration
