// A plan's memory as JSON, every number to the last bit. [m, rad, s]
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "planner/plan_memory.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json memoryJson(const planner::PlanMemory& memory);

/// Throws nlohmann::json::exception for anything that memoryJson does not write.
[[nodiscard]] planner::PlanMemory memoryFrom(const nlohmann::json& json);

}  // namespace tubeplan::app
