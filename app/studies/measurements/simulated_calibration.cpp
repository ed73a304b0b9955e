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

BestTouches bestTouches(const planner::Workcell& cell, const std::vector<calibration::TouchPlan>& candidates, int count,
                        const calibration::AdditionalUncertainty& additional) {
  std::vector<Eigen::VectorXd> work;
  for (const auto& candidate : candidates) work.push_back(candidate.q_start);
  return bestTouches(cell, candidates, work, count, additional);
}

BestTouches bestTouches(const planner::Workcell& cell, const std::vector<calibration::TouchPlan>& candidates,
                        const std::vector<Eigen::VectorXd>& work, int count,
                        const calibration::AdditionalUncertainty& additional) {
  return bestTouches(cell.arm, cell.X_WB, calibration::robustlyTouchable(cell.arm, cell.X_WB, candidates, count), work,
                     {count, touchSigmaOf(cell.tool), additional});
}

BestTouches bestTouches(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                        const std::vector<calibration::TouchPlan>& touchable, const std::vector<Eigen::VectorXd>& work,
                        const calibration::TouchChoiceOptions& options) {
  const auto choice = calibration::chooseTouches(arm, X_WB, touchable, work, options);
  if (choice.status != calibration::TouchChoiceStatus::kDone) return {{}, choice.reason};
  BestTouches best;
  for (int index : choice.chosen) {
    best.plans.push_back(touchable[static_cast<std::size_t>(index)]);
    best.plans.back().id = "T" + std::to_string(best.plans.size());
  }
  best.mean_sigma = choice.mean_sigma;
  return best;
}

namespace {

BothCalibrations calibrateBothBy(calibration::BaseCalibrationOptions options, const deflection::Arm& flexible,
                                 const deflection::Arm& rigid, const Eigen::Isometry3d& X_WB_start,
                                 const std::vector<calibration::Measurement>& touches) {
  BothCalibrations both;
  both.flexible = calibration::calibrateBase(flexible, touches, X_WB_start, options);
  // The error of a rigid model is inches, so large residuals do not indicate a mistaken hole, and no model error is
  // estimated.
  options.arm = calibration::ArmUncertainty::none();
  options.model_error = 0;
  options.mistaken_hole_p_value = 0;
  options.finds_model_error = false;
  options.finds_suspects = false;
  both.rigid = calibration::calibrateBase(rigid, touches, X_WB_start, options);
  return both;
}

}  // namespace

BothCalibrations calibrateBoth(const planner::Workcell& placed, const CellModel& cell,
                               const std::vector<calibration::Measurement>& touches) {
  return calibrateBothBy(calibrationOptionsOf(cell), placed.arm, deflection::rigidCopy(placed.arm), placed.X_WB,
                         touches);
}

BothCalibrations calibrateBoth(const deflection::Arm& flexible, const deflection::Arm& rigid,
                               const calibration::AdditionalUncertainty& additional,
                               const Eigen::Isometry3d& X_WB_start, const tubesheets::Sheet& sheet,
                               const std::vector<calibration::Measurement>& touches) {
  calibration::BaseCalibrationOptions options;
  options.arm = additional.arm;
  options.model_error = additional.model_error;
  options.finds_suspects = false;
  options.method = calibration::LeastSquaresMethod::kLevenbergMarquardt;
  options.neighbours = neighboursOn(sheet);
  return calibrateBothBy(options, flexible, rigid, X_WB_start, touches);
}

planner::Workcell withBase(planner::Workcell cell, const calibration::BaseCalibration& base) {
  cell.arm = base.arm;
  cell.X_WB = base.X_WB;
  cell.base_covariance = base.covariance;
  return cell;
}

}  // namespace tubeplan::app
