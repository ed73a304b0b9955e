#include "planner/scoring.hpp"

namespace tubeplan::planner {

Centring scoreVisit(const Workcell& truth, const Eigen::Vector3d& hole_W, const TubeBranch& visit,
                    const Eigen::Vector3d& tip_error_W) {
  Centring score;
  const Eigen::Vector3d off = predictTip(truth, visit.q).p_WT + tip_error_W - hole_W;
  score.offset = off.head<2>();
  score.error = score.offset.norm();
  score.height = off.z();
  score.approach_deviation = lateralDeviation(truth, hole_W - tip_error_W, visit.approach);
  score.steps = tubesheets::stepsInserted(truth.tool, score.error);
  return score;
}

std::vector<int> countSteps(const std::vector<Centring>& scores, int steps) {
  std::vector<int> counts(static_cast<std::size_t>(steps) + 1, 0);
  for (const auto& score : scores)
    if (score.steps >= 0 && score.steps <= steps) ++counts[static_cast<std::size_t>(score.steps)];
  return counts;
}

}  // namespace tubeplan::planner
