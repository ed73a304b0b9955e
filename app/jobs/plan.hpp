// The main job: touches, calibration, plan and score, from files named in a request to results in memory.
#pragma once

#include "app/documents/plan_outcome.hpp"
#include "app/files/checkpoint/plan_checkpoint.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// Reads, calibrates, plans and scores. Throws InputError for bad input. A calibration that is refused ends the job
/// with the plan not run. The keeper gives what is known already and keeps what is found out.
[[nodiscard]] PlanOutcome runPlanJob(const PlanRequest& request, planner::PlanHooks hooks, PlanCheckpoint& checkpoint);

/// Plans the visits of a cell at hand, its base where it is, and scores against the request's truth; of the request's
/// other files none is read, and nothing is kept. Its tubes are a selection, no file.
[[nodiscard]] PlanOutcome planCell(const Cell& cell, const PlanRequest& request, planner::PlanHooks hooks);

}  // namespace tubeplan::app
