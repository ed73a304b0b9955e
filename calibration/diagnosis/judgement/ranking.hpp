// Every cause by itself: how probable it is, and from what size on these readings would have shown it.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Fills `ranking`.
void rankCauses(const DiagnosisWork& work, Diagnosis& result);

/// Fills `detectable`.
void listDetectable(const DiagnosisWork& work, Diagnosis& result);

}  // namespace tubeplan::calibration
