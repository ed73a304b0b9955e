// Ranking of single causes: the probability of each cause, and the least size that these readings would have shown.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Sets `result.ranking`.
void rankCauses(const DiagnosisWork& work, Diagnosis& result);

/// Sets `result.detectable`.
void listDetectable(const DiagnosisWork& work, Diagnosis& result);

}  // namespace tubeplan::calibration
