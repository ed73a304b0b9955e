// Errors that remain unexplained by the causes of a model.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/judgement/same_posture.hpp"
#include "calibration/diagnosis/model_selection/competing_models.hpp"
#include "calibration/estimation/repeats.hpp"

namespace tubeplan::calibration {

/// Returns the errors that remain unexplained by a model's causes, and the variables that these errors follow.
[[nodiscard]] Remainder remainderOf(const DiagnosisWork& work, const CompetingModel& model);

/// Compares the errors of a model with the scatter of repeated measurements.
[[nodiscard]] Repeats repeatsBy(const DiagnosisWork& work, const CompetingModel& model);

/// Analyses whether the errors of a model repeat at equal postures. Uses the errors of the baseline if the model has no
/// causes or no fit.
[[nodiscard]] SamePosture samePostureBy(const DiagnosisWork& work, const CompetingModel& model);

}  // namespace tubeplan::calibration
