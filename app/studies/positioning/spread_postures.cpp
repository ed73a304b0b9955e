#include "app/studies/positioning/spread_postures.hpp"

#include <oneapi/tbb/parallel_for.h>

#include "planner/reach/compensation.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

SpreadPostures spreadPostures(const CellModel& cell, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                              std::size_t most, const calibration::StopQuestion& stop) {
  SpreadPostures spread;
  if (!cell.sheet || !cell.tool_axis_stated) return spread;
  const auto tubes = tubesheets::selectTubes(*cell.sheet, tubesheets::spreadRequest(*cell.sheet, most)).tube_indices;
  spread.asked = static_cast<int>(tubes.size());
  planner::Workcell work;
  work.arm = arm;
  work.X_WB = X_WB;
  planner::CompensationOptions options;
  options.with_approach = false;
  options.inverse.most_branches = 4;  // the first that converges is taken
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

}  // namespace tubeplan::app
