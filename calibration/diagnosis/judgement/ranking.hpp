// Ranking of single causes by their probability, and the smallest size of each effect that these measurements would
// have revealed.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Sets `result.ranking`: single causes, most probable first.
void rankCauses(const DiagnosisWork& work, Diagnosis& result);

/// Sets `result.detectable`: the smallest detectable size of each effect at each place.
void listDetectable(const DiagnosisWork& work, Diagnosis& result);

}  // namespace tubeplan::calibration
