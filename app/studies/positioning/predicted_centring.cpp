#include "app/studies/positioning/predicted_centring.hpp"

#include <oneapi/tbb/parallel_for.h>

#include "planner/reach/compensation.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

using calibration::CentringForecastStatus;

constexpr std::size_t kHoles = 200;

/// Postures under holes spread over a cell's sheet, which represent the work of the arm.
struct SpreadPostures {
  std::vector<int> tubes;                 ///< indices, in the sheet, of the tubes in reach
  std::vector<Eigen::VectorXd> postures;  ///< a posture for each of `tubes`: the first branch found
  int tried = 0;                          ///< number of holes tried, including those out of reach
};

/// Returns postures under at most `most` holes of the sheet. Empty if the cell has no sheet or does not state the
/// direction of insertion. Collisions are not checked. The result is invalid if `stop` has returned true.
SpreadPostures spreadPostures(const CellModel& cell, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                              std::size_t most, const calibration::StopQuestion& stop) {
  SpreadPostures spread;
  if (!cell.sheet || !cell.tool_axis_stated) return spread;
  const auto tubes = tubesheets::selectTubes(*cell.sheet, tubesheets::spreadRequest(*cell.sheet, most)).tube_indices;
  spread.tried = static_cast<int>(tubes.size());
  planner::Workcell work;
  work.arm = arm;
  work.X_WB = X_WB;
  planner::CompensationOptions options;
  options.with_approach = false;
  options.inverse.most_branches = 4;  // only the first branch is used
  std::vector<Eigen::VectorXd> found(tubes.size());
  oneapi::tbb::parallel_for(std::size_t{0}, tubes.size(), [&](std::size_t k) {
    if (calibration::shouldStop(stop)) return;
    const auto& tube = cell.sheet->tubes[static_cast<std::size_t>(tubes[k])];
    const auto branches = planner::compensate(work, planner::holeCentre(tube), options);
    if (!branches.empty() && branches.front().status == deflection::BranchStatus::kConverged)
      found[k] = branches.front().q;
  });
  for (std::size_t k = 0; k < tubes.size(); ++k) {
    if (found[k].size() == 0) continue;
    spread.tubes.push_back(tubes[k]);
    spread.postures.push_back(found[k]);
  }
  return spread;
}

}  // namespace

PredictedCentring predictCentring(const CellModel& cell, const calibration::Identification& fit, bool is_staged,
                                  const calibration::StopQuestion& stop) {
  PredictedCentring predicted;
  predicted.later_stage = is_staged;
  if (!cell.sheet)
    predicted.reason = "the cell has no tube sheet";
  else if (!cell.tool_axis_stated)
    predicted.reason = "the cell does not state the tool's insertion direction";
  else if (fit.status != calibration::IdentificationStatus::kDone)
    predicted.reason = "nothing was identified";
  if (!predicted.reason.empty()) return predicted;
  const SpreadPostures reached = spreadPostures(cell, fit.fitted.arm, fit.fitted.base_poses.back().X_WB, kHoles, stop);
  predicted.on_sheet = static_cast<int>(cell.sheet->tubes.size());
  predicted.holes = static_cast<int>(reached.tubes.size());
  predicted.out_of_reach = reached.tried - predicted.holes;
  calibration::CentringForecastOptions options;
  options.base_covariance = cell.base_covariance;
  predicted.forecast = calibration::forecastCentring(fit, reached.postures, options);
  predicted.reason = reached.postures.empty() ? "the arm reaches none of the holes" : predicted.forecast.reason;
  if (predicted.forecast.status != CentringForecastStatus::kDone) return predicted;
  const auto worst = static_cast<std::size_t>(predicted.forecast.worst_posture);
  const auto& tube = cell.sheet->tubes[static_cast<std::size_t>(reached.tubes[worst])];
  predicted.worst_hole = tubesheets::tubeName(tube.row, tube.column);
  return predicted;
}

}  // namespace tubeplan::app
