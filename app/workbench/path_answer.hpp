// The path of a plan as the page plays it, and how far the arm is from everything along it.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

/// {units, time, segment, kind, joints, tube, clearance}: samples at most about 20,000; the clearance that is proved of
/// each segment.
[[nodiscard]] nlohmann::json pathAnswer(const PlanOutcome& outcome);

inline constexpr std::size_t kMostClearances = 2000;

/// {units, from, samples, clearance}: of `count` (at most kMostClearances) of the path's samples from the one at `from`
/// on, the distance to what is nearest at that posture, by the rule of its segment; null where there is nothing to
/// touch. Throws InputError for a `from` beyond the path.
[[nodiscard]] nlohmann::json clearanceAlong(const PlanOutcome& outcome, std::size_t from, std::size_t count);

}  // namespace tubeplan::app
