#include "calibration/touch_reserve.hpp"

#include <algorithm>
#include <cmath>

namespace tubeplan::calibration {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Shares of the doubt, by axis: shifts, then turns.
std::vector<Vector6> waysOff() {
  std::vector<Vector6> ways;
  for (int axis = 0; axis < 6; ++axis)
    for (const double sign : {-1., 1.}) ways.push_back(sign * Vector6::Unit(axis));
  for (int corner = 0; corner < 64; ++corner) {
    Vector6 way;
    for (int axis = 0; axis < 6; ++axis) way[axis] = (corner >> axis & 1 ? 1 : -1) / std::sqrt(6.);
    ways.push_back(way);
  }
  return ways;
}

Eigen::Isometry3d displaced(const Eigen::Isometry3d& X_WB, const Vector6& way, const BaseDoubt& doubt) {
  Eigen::Isometry3d X = X_WB;
  X.translation() += doubt.shift * way.head<3>();
  const Eigen::Vector3d turn = doubt.turn * way.tail<3>();
  if (turn.norm() > 0) X.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * X_WB.linear();
  return X;
}

}  // namespace

std::vector<TouchPlan> keepTouchable(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                     const std::vector<TouchPlan>& candidates, const BaseDoubt& doubt) {
  std::vector<Eigen::Isometry3d> bases;
  for (const Vector6& way : waysOff()) bases.push_back(displaced(X_WB, way, doubt));
  TouchSimulationOptions exact;
  exact.sigma = 0;
  std::vector<TouchPlan> kept;
  std::ranges::copy_if(candidates, std::back_inserter(kept), [&](const TouchPlan& candidate) {
    return std::ranges::all_of(bases, [&](const Eigen::Isometry3d& X) {
      return simulateTouches(arm, X, {candidate}, exact).status == TouchSimulationStatus::kDone;
    });
  });
  return kept;
}

}  // namespace tubeplan::calibration
