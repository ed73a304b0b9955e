// Path of a plan in the form that the page plays, with the clearance along it.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

/// Returns {units, time, segment, kind, joints, tube, clearance}: at most about 20,000 samples; the proved clearance of
/// each segment.
[[nodiscard]] nlohmann::json pathAnswer(const PlanOutcome& outcome);

inline constexpr std::size_t kMostClearances = 2000;

/// Returns {units, from, samples, clearance}: for `count` (at most kMostClearances) samples of the path, beginning with
/// index `from`, the distance to the nearest object at that posture, by the rule of its segment; null without objects.
/// Throws InputError for a `from` beyond the path.
[[nodiscard]] nlohmann::json clearanceAlong(const PlanOutcome& outcome, std::size_t from, std::size_t count);

}  // namespace tubeplan::app
