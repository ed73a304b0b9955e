#include "planner/reach/insertion.hpp"

#include <algorithm>
#include <limits>

#include "planner/reach/tip_prediction.hpp"

namespace tubeplan::planner {

double playInTube(const Workcell& cell, const Eigen::Vector3d& hole_W, const std::vector<Eigen::VectorXd>& postures) {
  double least = std::numeric_limits<double>::infinity();
  if (!(cell.insertion > 0)) return least;
  TipPrediction tips(cell);
  const auto look = [&](const Eigen::VectorXd& q) {
    const PredictedTip tip = tips.at(q);
    const Eigen::Vector3d off = tip.p_WT - hole_W;
    const Eigen::Vector2d lean = tip.axis_W.head<2>() / tip.axis_W.z();
    const double play = tubesheets::playInTube(cell.tool, off.head<2>(), lean, off.z());
    least = off.allFinite() ? std::min(least, play) : -std::numeric_limits<double>::infinity();
  };
  for (std::size_t k = 0; k < postures.size(); ++k) {
    if (k > 0) look((postures[k - 1] + postures[k]) / 2);
    look(postures[k]);
  }
  return least;
}

}  // namespace tubeplan::planner
