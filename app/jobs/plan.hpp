// The planning job: reads the files of a request, calibrates, plans and scores, and returns the results in memory.
#pragma once

#include "app/documents/plan_outcome.hpp"
#include "app/formats/checkpoint/plan_checkpoint.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// Reads the input, calibrates the base from the touches if there are any, and plans and scores the visits. Throws
/// InputError for bad input. If the calibration is refused, nothing is planned. `checkpoint` supplies results of an
/// earlier run and stores new ones.
[[nodiscard]] PlanOutcome runPlanJob(const PlanRequest& request, planner::PlanHooks hooks, PlanCheckpoint& checkpoint);

/// Plans the visits of a given cell with its current base, and scores them against the request's truth. Of the
/// request's files only the truth is read. `tubes` of the request is a selection, not a file name. `checkpoint`
/// supplies results of an earlier plan; null if there are none.
[[nodiscard]] PlanOutcome planCell(const Cell& cell, const PlanRequest& request, planner::PlanHooks hooks,
                                   PlanCheckpoint* checkpoint = nullptr);

}  // namespace tubeplan::app
