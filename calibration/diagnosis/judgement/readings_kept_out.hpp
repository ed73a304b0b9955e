// Errors of explanations on readings to which they were not fitted.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Sets the errors before and after adding each explanation, evaluated on the held-out readings. Without held-out
/// readings, the errors are evaluated fold by fold. The errors at the farthest quarter of the poses are set as well.
/// Drops explanations that do not lower the error, which may change the verdict.
void judgeByReadingsKeptOut(const DiagnosisWork& work, const std::vector<Measurement>& kept_out, Diagnosis& result);

}  // namespace tubeplan::calibration
