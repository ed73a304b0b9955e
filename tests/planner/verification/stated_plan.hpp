// A plan in the form of a plan file.
#pragma once

#include "planner/verification/plan_checks.hpp"

namespace tubeplan::planner::testing {

inline StatedPlan statedPlan(const Workcell& cell, const VisitPlan& plan) {
  StatedPlan stated;
  for (const auto& visit : plan.visits) {
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(visit.tube)];
    const Eigen::Vector3d &tip = visit.branch.predicted_tip_W, place = visitPlace(cell, tube);
    stated.tubes.push_back({tube.row, tube.column, holeCentre(tube), visit.branch.q, tip, visit.dwell, 0,
                            (tip - place).head<2>().norm(), visit.branch.tilt});
  }
  for (const auto& missed : plan.unreachable) {
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(missed.tube)];
    stated.unreachable.emplace_back(tube.row, tube.column);
  }
  if (plan.segments.front().kind != SegmentKind::kApproach) stated.start = plan.segments.front().waypoints.front();
  if (plan.segments.back().kind == SegmentKind::kTravel) stated.end = plan.segments.back().waypoints.back();
  stated.path = samplePath(plan, jointSpeedsOf(cell.arm));
  stated.travel_time = plan.travel_time;
  stated.total_time = plan.total_time;
  stated.least_clearance = plan.min_margin + cell.scene.clearance;
  return stated;
}

}  // namespace tubeplan::planner::testing
