// The plan of a kept session. Its request is stored, and the plan is made again from it, because a plan refers to
// planner objects in memory; the same request gives the same plan.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

class Workbench;

[[nodiscard]] nlohmann::json planRequestJson(const PlanRequest& request);

/// Returns the request with this JSON. Throws nlohmann::json::exception for other JSON.
[[nodiscard]] PlanRequest planRequestOf(const nlohmann::json& json);

/// Begins a job that recomputes the session's stored plan; does nothing if the session has none.
void restorePlan(Workbench& workbench);

}  // namespace tubeplan::app
