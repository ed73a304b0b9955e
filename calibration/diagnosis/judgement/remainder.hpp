// What is left beside the causes of a model.
#pragma once

#include "calibration/diagnosis/judgement/diagnosis_result.hpp"
#include "calibration/diagnosis/judgement/same_posture.hpp"
#include "calibration/diagnosis/model_selection/competing_models.hpp"
#include "calibration/estimation/repeats.hpp"

namespace tubeplan::calibration {

/// What is left beside a model's causes, and what it follows.
[[nodiscard]] Remainder remainderOf(const DiagnosisWork& work, const CompetingModel& model);

/// What a model leaves by the readings that were made alike: whether their scatter is all of it.
[[nodiscard]] Repeats repeatsBy(const DiagnosisWork& work, const CompetingModel& model);

/// Of the errors that a model leaves; those of the baseline where it has no causes, or no fit.
[[nodiscard]] SamePosture samePostureBy(const DiagnosisWork& work, const CompetingModel& model);

}  // namespace tubeplan::calibration
