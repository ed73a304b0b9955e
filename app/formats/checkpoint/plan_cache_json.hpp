// Conversion of a plan's cache to JSON and back [m, rad, s], with numbers at full precision.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "planner/plan_cache.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json cacheJson(const planner::PlanCache& cache);

/// Returns the plan's cache from its JSON. Throws nlohmann::json::exception for JSON that cacheJson() does not write.
[[nodiscard]] planner::PlanCache cacheFrom(const nlohmann::json& json);

}  // namespace tubeplan::app
