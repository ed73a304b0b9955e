// Errors of explanations on measurements that were excluded from their fits.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Sets the errors before and after adding each explanation, evaluated on the held-out measurements or, if there are
/// none, by cross-validation. Also sets the errors at the quarter of the poses that reach farthest. Drops explanations
/// that do not lower the error, which may change the verdict.
void judgeByMeasurementsKeptOut(const DiagnosisWork& work, const std::vector<Measurement>& kept_out, Diagnosis& result);

}  // namespace tubeplan::calibration
