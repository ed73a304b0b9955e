// How explanations do on readings that they were not fitted to.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Fills the errors before and after, by the readings kept out or, where there are none, fold by fold and by the
/// farthest quarter of the poses; what does not lower them is no explanation.
void judgeByReadingsKeptOut(const DiagnosisWork& work, const std::vector<Measurement>& kept_out, Diagnosis& result);

}  // namespace tubeplan::calibration
