// The leaders among the competing models, whose evidence is taken about a fit of their own.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Fits the leading ones and that of nothing missing. Unwinds where it was stopped.
void fitLeaders(DiagnosisWork& work);

/// The model of these effects, all their numbers, fitted from where linear evidence has them and, where their values
/// are not neutral, from these: the more probable end. Without a fit where one of them is no cause.
[[nodiscard]] CompetingModel fittedModelOf(const DiagnosisWork& work, const std::vector<deflection::Effect>& effects);

/// Of log weight behind the best model, within which linear evidence may err: those are fitted.
[[nodiscard]] double leaderWindow(double best, double nothing);

}  // namespace tubeplan::calibration
