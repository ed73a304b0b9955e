// When a step happened, as finely as the readings' times can say.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// A step between two readings is the same wherever it is between them: the gaps near the level are tried, of very
/// many first some, then all between the neighbours of the best.
[[nodiscard]] double refinedTime(const DiagnosisWork& work, const CompetingModel& model, std::size_t index);

}  // namespace tubeplan::calibration
