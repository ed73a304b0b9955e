// A plan's memory as JSON [m, rad, s], every number exact to the last bit.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "planner/plan_cache.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json cacheJson(const planner::PlanCache& cache);

/// Returns the memory of a plan from its JSON. Throws nlohmann::json::exception for anything that cacheJson does not
/// write.
[[nodiscard]] planner::PlanCache cacheFrom(const nlohmann::json& json);

}  // namespace tubeplan::app
