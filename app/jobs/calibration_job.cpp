#include "app/jobs/calibration_job.hpp"

#include "app/documents/calibration_json.hpp"
#include "app/documents/step_chances_json.hpp"
#include "app/files/cell_writer.hpp"
#include "app/files/input_error.hpp"
#include "app/studies/measurements/touched_holes.hpp"
#include "app/studies/positioning/step_chances.hpp"
#include "deflection/inverse/rigid_branches.hpp"
#include "planner/reach/compensation.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kWorkHoles = 40;
constexpr std::size_t kHolesOfSlowArms = 8;  // whose inverse kinematics is a search

/// In which the arm works: under holes spread over the sheet; none where the cell does not say how.
std::vector<Eigen::VectorXd> workPostures(const Cell& cell, const Eigen::Isometry3d& X_WB) {
  std::vector<Eigen::VectorXd> postures;
  if (!cell.sheet || !cell.tool_axis_stated) return postures;
  planner::Workcell work;
  work.arm = cell.arm;
  work.X_WB = X_WB;
  planner::CompensationOptions options;
  options.with_approach = false;
  const std::size_t most = deflection::isTurretArm(cell.arm) ? kWorkHoles : kHolesOfSlowArms;
  const auto spread = tubesheets::selectTubes(*cell.sheet, tubesheets::spreadRequest(*cell.sheet, most));
  for (const int tube : spread.tube_indices) {
    const auto hole = planner::holeCentre(cell.sheet->tubes[static_cast<std::size_t>(tube)]);
    const auto branches = planner::compensate(work, hole, options);
    if (!branches.empty() && branches.front().status == deflection::BranchStatus::kConverged)
      postures.push_back(branches.front().q);
  }
  return postures;
}

std::optional<ModelError> modelErrorOf(const Cell& cell, const calibration::BaseCalibration& base,
                                       const std::vector<calibration::Measurement>& touches) {
  if (base.status != calibration::CalibrationStatus::kDone || isFoundElsewhere(cell.model_error)) return std::nullopt;
  const double load = touches.front().load;
  const calibration::TipErrorQuestion asked{
      cell.arm, base.X_WB, load, touches, base.covariance, std::nullopt, workPostures(cell, base.X_WB)};
  return modelErrorByTouches(calibration::findTipError(asked), touches.size());
}

}  // namespace

CalibrationOutcome calibrateCell(const Cell& cell, const std::vector<calibration::Measurement>& touches,
                                 const std::string& file) {
  if (const auto problem = calibration::findTouchProblem(touches); !problem.empty())
    throw InputError(file, problem, "three or more different holes, well spread", "touch another hole");
  CalibrationOutcome outcome;
  calibration::BaseCalibrationOptions options;
  if (cell.sheet) options.neighbours = neighboursOn(*cell.sheet);
  outcome.calibration = calibration::calibrateBase(cell.arm, touches, cell.X_WB, options);
  outcome.model_error = modelErrorOf(cell, outcome.calibration, touches);
  outcome.figures = calibrationJson(outcome.calibration, cell);
  if (outcome.model_error) outcome.figures["model_error"] = modelErrorJson(*outcome.model_error, cell.units);
  return outcome;
}

std::string calibratedCellText(const Cell& cell, const CalibrationOutcome& outcome, const std::string& out) {
  const auto& base = outcome.calibration;
  return cellTextWithBase(cell, {base.X_WB, base.covariance, true, outcome.model_error}, out);
}

}  // namespace tubeplan::app
