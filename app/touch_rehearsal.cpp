#include "app/touch_rehearsal.hpp"

#include <algorithm>

#include "app/input_error.hpp"
#include "app/touch_input.hpp"
#include "planner/tube_reach.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

std::vector<calibration::TouchPlan> touchCandidates(const planner::Workcell& cell, int count) {
  const auto selection = tubesheets::selectTubes(
      cell.sheet, "spread:" + std::to_string(std::min<std::size_t>(count, cell.sheet.tubes.size())));
  const planner::ArmClearance clearance(cell);
  std::vector<calibration::TouchPlan> candidates;
  for (int index : selection.tube_indices) {
    const auto reach = planner::reachTube(clearance, index);
    if (reach.status != planner::ReachStatus::kReachable) continue;
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(index)];
    candidates.push_back(
        {"", tubesheets::tubeName(tube.row, tube.column), planner::holeCentre(tube), reach.branches.front().q});
  }
  return candidates;
}

std::vector<calibration::TouchPlan> bestTouches(const planner::Workcell& cell,
                                                const std::vector<calibration::TouchPlan>& candidates, int count) {
  std::vector<Eigen::VectorXd> work;
  for (const auto& candidate : candidates) work.push_back(candidate.q_start);
  const auto choice =
      calibration::chooseTouches(cell.arm, cell.X_WB, candidates, work, {count, touchSigmaOf(cell.tool)});
  if (choice.status != calibration::TouchChoiceStatus::kDone)
    throw InputError("--touches auto", choice.reason, "holes to touch",
                     "check base, scene and joint limits of the cell");
  std::vector<calibration::TouchPlan> plans;
  for (int index : choice.chosen) {
    plans.push_back(candidates[static_cast<std::size_t>(index)]);
    plans.back().id = "T" + std::to_string(plans.size());
  }
  return plans;
}

BothCalibrations calibrateBoth(const planner::Workcell& cell, const std::vector<calibration::Touch>& touches) {
  BothCalibrations both;
  both.flexible = calibration::calibrateBase(cell.arm, touches, cell.X_WB);
  // A rigid model is off by inches; that is no sign of a mistaken hole.
  calibration::BaseCalibrationOptions blunt;
  blunt.model_sigma = 1;
  both.rigid = calibration::calibrateBase(deflection::rigidCopy(cell.arm), touches, cell.X_WB, blunt);
  return both;
}

planner::Workcell withBase(planner::Workcell cell, const calibration::BaseCalibration& base) {
  cell.X_WB = base.X_WB;
  cell.base_covariance = calibration::widenedCovariance(base);
  return cell;
}

}  // namespace tubeplan::app
