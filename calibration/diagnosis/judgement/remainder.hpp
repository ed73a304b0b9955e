// Errors that remain beside the causes of a model.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/judgement/same_posture.hpp"
#include "calibration/diagnosis/model_selection/competing_models.hpp"
#include "calibration/estimation/repeats.hpp"

namespace tubeplan::calibration {

/// Returns the errors that remain beside a model's causes, and the variables that they follow.
[[nodiscard]] Remainder remainderOf(const DiagnosisWork& work, const CompetingModel& model);

/// Compares the errors of a model with the scatter of repeated readings.
[[nodiscard]] Repeats repeatsBy(const DiagnosisWork& work, const CompetingModel& model);

/// Judges the errors of a model at equal postures; of the baseline if it has no causes or no fit.
[[nodiscard]] SamePosture samePostureBy(const DiagnosisWork& work, const CompetingModel& model);

}  // namespace tubeplan::calibration
