// Conversion of a plan's cache to JSON and back [m, rad, s], with numbers at full precision.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "planner/plan_cache.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json cacheJson(const planner::PlanCache& cache);

/// Return the JSON of one entry, as it is in the lists `reach`, `travels` and `proofs` of the cache's JSON.
[[nodiscard]] nlohmann::json reachJson(const planner::TubeReach& reach);
[[nodiscard]] nlohmann::json travelJson(const planner::MotionEnds& ends, const planner::MotionPlan& plan);
[[nodiscard]] nlohmann::json proofJson(const planner::MotionEnds& ends, const planner::SegmentProof& proof);

/// Returns the JSON of the cache without these lists: an object with the remaining keys.
[[nodiscard]] nlohmann::json wholePlanJson(const planner::PlanCache& cache);

/// Return one entry from its JSON. Throw nlohmann::json::exception for JSON that the functions above do not write.
[[nodiscard]] planner::TubeReach reachFrom(const nlohmann::json& object);
[[nodiscard]] planner::MotionPlan travelFrom(const nlohmann::json& object);
[[nodiscard]] planner::SegmentProof proofFrom(const nlohmann::json& object);
[[nodiscard]] planner::PlanCache wholePlanFrom(const nlohmann::json& object);

/// Returns the plan's cache from its JSON. Throws nlohmann::json::exception for JSON that cacheJson() does not write.
[[nodiscard]] planner::PlanCache cacheFrom(const nlohmann::json& json);

}  // namespace tubeplan::app
