// A plan as its files would state it.
#pragma once

#include "planner/verification/plan_checks.hpp"

namespace tubeplan::planner::testing {

inline StatedPlan statedPlan(const Workcell& cell, const VisitPlan& plan) {
  StatedPlan stated;
  for (const auto& visit : plan.visits) {
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(visit.tube)];
    stated.tubes.push_back(
        {tube.row, tube.column, holeCentre(tube), visit.branch.q, visit.branch.predicted_tip_W, visit.dwell, 0});
  }
  for (const auto& missed : plan.unreachable) {
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(missed.tube)];
    stated.unreachable.emplace_back(tube.row, tube.column);
  }
  stated.path = samplePath(plan, jointSpeedsOf(cell.arm));
  return stated;
}

}  // namespace tubeplan::planner::testing
