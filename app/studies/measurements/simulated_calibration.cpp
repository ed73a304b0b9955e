#include "app/studies/measurements/simulated_calibration.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "app/studies/measurements/touched_holes.hpp"
#include "calibration/design/touch_reserve.hpp"
#include "planner/reach/tube_reach.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

std::vector<calibration::TouchPlan> touchCandidates(const planner::Workcell& cell, int count) {
  const std::string spread = tubesheets::spreadRequest(cell.sheet, static_cast<std::size_t>(count));
  return touchCandidates(cell, tubesheets::selectTubes(cell.sheet, spread).tube_indices);
}

std::vector<calibration::TouchPlan> touchCandidates(const planner::Workcell& cell, const std::vector<int>& tubes) {
  const planner::ArmClearance clearance(cell);
  std::vector<planner::TubeReach> reach(tubes.size());
  oneapi::tbb::parallel_for(std::size_t{0}, tubes.size(),
                            [&](std::size_t k) { reach[k] = planner::reachTube(clearance, tubes[k]); });
  std::vector<calibration::TouchPlan> candidates;
  for (std::size_t k = 0; k < tubes.size(); ++k) {
    if (reach[k].status != planner::ReachStatus::kReachable) continue;
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(tubes[k])];
    candidates.push_back(
        {"", tubesheets::tubeName(tube.row, tube.column), planner::holeCentre(tube), reach[k].branches.front().q});
  }
  return candidates;
}

int tubeOf(const calibration::TouchPlan& candidate, const tubesheets::Sheet& sheet) {
  const auto name = tubesheets::parseTubeName(candidate.hole);
  return *sheet.indexOf(name->row, name->column);
}

BestTouches bestTouches(const planner::Workcell& cell, const std::vector<calibration::TouchPlan>& candidates,
                        int count) {
  std::vector<Eigen::VectorXd> work;
  for (const auto& candidate : candidates) work.push_back(candidate.q_start);
  auto touchable = calibration::keepTouchable(cell.arm, cell.X_WB, candidates);
  if (static_cast<int>(touchable.size()) < count) touchable = candidates;
  const auto choice =
      calibration::chooseTouches(cell.arm, cell.X_WB, touchable, work, {count, touchSigmaOf(cell.tool)});
  if (choice.status != calibration::TouchChoiceStatus::kDone) return {{}, choice.reason};
  std::vector<calibration::TouchPlan> plans;
  for (int index : choice.chosen) {
    plans.push_back(touchable[static_cast<std::size_t>(index)]);
    plans.back().id = "T" + std::to_string(plans.size());
  }
  return {std::move(plans), {}};
}

BothCalibrations calibrateBoth(const planner::Workcell& cell, const std::vector<calibration::Measurement>& touches) {
  return calibrateBoth(cell.arm, deflection::rigidCopy(cell.arm), cell.X_WB, cell.sheet, touches);
}

BothCalibrations calibrateBoth(const deflection::Arm& flexible, const deflection::Arm& rigid,
                               const Eigen::Isometry3d& X_WB_start, const tubesheets::Sheet& sheet,
                               const std::vector<calibration::Measurement>& touches,
                               calibration::LeastSquaresMethod method) {
  BothCalibrations both;
  calibration::BaseCalibrationOptions options;
  options.method = method;
  options.neighbours = neighboursOn(sheet);
  both.flexible = calibration::calibrateBase(flexible, touches, X_WB_start, options);
  // A rigid model is off by inches; that is no sign of a mistaken hole, nor does who works with it look for its error.
  options.mistaken_hole_p_value = 0;
  options.model_error = 0;
  both.rigid = calibration::calibrateBase(rigid, touches, X_WB_start, options);
  return both;
}

planner::Workcell withBase(planner::Workcell cell, const calibration::BaseCalibration& base) {
  cell.X_WB = base.X_WB;
  cell.base_covariance = base.covariance;
  return cell;
}

}  // namespace tubeplan::app
