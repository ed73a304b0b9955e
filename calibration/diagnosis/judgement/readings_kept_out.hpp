// Errors of explanations on readings that they were not fitted to.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Sets the errors before and after, from the readings kept out; without any, fold by fold and from the farthest
/// quarter of the poses. Drops explanations that do not lower the error.
void judgeByReadingsKeptOut(const DiagnosisWork& work, const std::vector<Measurement>& kept_out, Diagnosis& result);

}  // namespace tubeplan::calibration
