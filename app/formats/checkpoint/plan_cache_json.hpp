// A plan's memory as JSON, every number to the last bit. [m, rad, s]
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "planner/plan_cache.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json cacheJson(const planner::PlanCache& cache);

/// Throws nlohmann::json::exception for anything that cacheJson does not write.
[[nodiscard]] planner::PlanCache cacheFrom(const nlohmann::json& json);

}  // namespace tubeplan::app
