#include "planner/reach/scoring.hpp"

namespace tubeplan::planner {

Centring scoreVisit(TipPrediction& tips, const Workcell& truth, const Eigen::Vector3d& hole_W, const TubeBranch& visit,
                    const Eigen::Vector3d& tip_error_W) {
  Centring score;
  const PredictedTip tip = tips.at(visit.q);
  const Eigen::Vector3d off = tip.p_WT + tip_error_W - hole_W;
  score.offset = off.head<2>();
  score.error = score.offset.norm();
  score.height = off.z();
  score.approach_deviation = tips.lateralDeviation(hole_W - tip_error_W, visit.approach);
  score.lean = tip.axis_W.head<2>() / tip.axis_W.z();
  score.steps = tubesheets::stepsInserted(truth.tool, score.offset, score.lean);
  return score;
}

Centring scoreVisit(const Workcell& truth, const Eigen::Vector3d& hole_W, const TubeBranch& visit,
                    const Eigen::Vector3d& tip_error_W) {
  TipPrediction tips(truth);
  return scoreVisit(tips, truth, hole_W, visit, tip_error_W);
}

std::vector<int> countSteps(const std::vector<Centring>& scores, int steps) {
  std::vector<int> counts(static_cast<std::size_t>(steps) + 1, 0);
  for (const auto& score : scores)
    if (score.steps >= 0 && score.steps <= steps) ++counts[static_cast<std::size_t>(score.steps)];
  return counts;
}

}  // namespace tubeplan::planner
