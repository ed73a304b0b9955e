#include "app/studies/positioning/predicted_centring.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "deflection/inverse/rigid_branches.hpp"
#include "planner/reach/compensation.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

using calibration::CentringForecastStatus;
using Eigen::VectorXd;

constexpr std::size_t kHoles = 200;
constexpr std::size_t kHolesOfSlowArms = 20;  // whose inverse kinematics is a search

struct Reached {
  std::vector<int> tubes;
  std::vector<VectorXd> postures;
};

std::vector<int> holesToLookAt(const CellModel& cell) {
  const std::size_t most = deflection::isTurretArm(cell.arm) ? kHoles : kHolesOfSlowArms;
  return tubesheets::selectTubes(*cell.sheet, tubesheets::spreadRequest(*cell.sheet, most)).tube_indices;
}

Reached reach(const CellModel& cell, const calibration::PlacedArm& placed, const std::vector<int>& tubes,
              const calibration::StopQuestion& stop) {
  planner::Workcell work;
  work.arm = placed.arm;
  work.X_WB = placed.base_poses.back().X_WB;
  planner::CompensationOptions options;
  options.with_approach = false;
  std::vector<VectorXd> postures(tubes.size());
  oneapi::tbb::parallel_for(std::size_t{0}, tubes.size(), [&](std::size_t k) {
    if (calibration::shouldStop(stop)) return;
    const auto& tube = cell.sheet->tubes[static_cast<std::size_t>(tubes[k])];
    const auto branches = planner::compensate(work, planner::holeCentre(tube), options);
    if (!branches.empty() && branches.front().status == deflection::BranchStatus::kConverged)
      postures[k] = branches.front().q;
  });
  Reached reached;
  for (std::size_t k = 0; k < tubes.size(); ++k) {
    if (postures[k].size() == 0) continue;
    reached.tubes.push_back(tubes[k]);
    reached.postures.push_back(postures[k]);
  }
  return reached;
}

}  // namespace

PredictedCentring predictCentring(const CellModel& cell, const calibration::Identification& fit, bool is_staged,
                                  const calibration::StopQuestion& stop) {
  PredictedCentring predicted;
  predicted.later_stage = is_staged;
  if (!cell.sheet)
    predicted.reason = "the cell has no tube sheet";
  else if (!cell.tool_axis_stated)
    predicted.reason = "the cell does not say which way the tool enters a hole";
  else if (fit.status != calibration::IdentificationStatus::kDone)
    predicted.reason = "nothing was identified";
  if (!predicted.reason.empty()) return predicted;
  const auto tubes = holesToLookAt(cell);
  const Reached reached = reach(cell, fit.fitted, tubes, stop);
  predicted.on_sheet = static_cast<int>(cell.sheet->tubes.size());
  predicted.holes = static_cast<int>(reached.tubes.size());
  predicted.out_of_reach = static_cast<int>(tubes.size()) - predicted.holes;
  calibration::CentringForecastOptions options;
  options.base_covariance = cell.base_covariance;
  predicted.forecast = calibration::forecastCentring(fit, reached.postures, options);
  predicted.reason =
      reached.postures.empty() ? "the arm reaches no hole that was looked at" : predicted.forecast.reason;
  if (predicted.forecast.status != CentringForecastStatus::kDone) return predicted;
  const auto worst = static_cast<std::size_t>(predicted.forecast.worst_posture);
  const auto& tube = cell.sheet->tubes[static_cast<std::size_t>(reached.tubes[worst])];
  predicted.worst_hole = tubesheets::tubeName(tube.row, tube.column);
  return predicted;
}

}  // namespace tubeplan::app
