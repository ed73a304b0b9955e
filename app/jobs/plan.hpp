// The main job: touches, calibration, plan and score, from the files of a request to results in memory.
#pragma once

#include "app/documents/plan_outcome.hpp"
#include "app/formats/checkpoint/plan_checkpoint.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// Reads, calibrates, plans and scores. Throws InputError for bad input. If the calibration is refused, the plan is not
/// run. `checkpoint` supplies known results and keeps new ones.
[[nodiscard]] PlanOutcome runPlanJob(const PlanRequest& request, planner::PlanHooks hooks, PlanCheckpoint& checkpoint);

/// Plans the visits of a given cell with its present base, and scores against the request's truth. No other file of the
/// request is read, and nothing is kept. Its tubes are a selection, not a file.
[[nodiscard]] PlanOutcome planCell(const Cell& cell, const PlanRequest& request, planner::PlanHooks hooks);

}  // namespace tubeplan::app
