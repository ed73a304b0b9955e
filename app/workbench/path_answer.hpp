// Path of a plan in the form that the page plays back, with the clearance along the path.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

/// Returns {units, time, segment, kind, joints, tube, clearance}. The path has at most about 20,000 samples;
/// `clearance` is the proved clearance of each segment.
[[nodiscard]] nlohmann::json pathAnswer(const PlanOutcome& outcome);

inline constexpr std::size_t kMostClearances = 2000;

/// Returns {units, from, samples, clearance} for `count` samples (at most kMostClearances) of the path, beginning with
/// index `from`. `clearance` is the distance to the nearest object under the contact rule of the sample's segment; null
/// without objects. Throws InputError for a `from` beyond the path.
[[nodiscard]] nlohmann::json clearanceAlong(const PlanOutcome& outcome, std::size_t from, std::size_t count);

}  // namespace tubeplan::app
