#include "calibration/design/touch_reserve.hpp"

#include <cmath>

namespace tubeplan::calibration {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Returns the trial errors of the base pose: unit vectors along each axis with either sign, and along each diagonal.
/// The first three components are fractions of BaseUncertainty::shift, the last three of BaseUncertainty::turn.
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

Eigen::Isometry3d displaced(const Eigen::Isometry3d& X_WB, const Vector6& way, const BaseUncertainty& uncertainty) {
  Eigen::Isometry3d X = X_WB;
  X.translation() += uncertainty.shift * way.head<3>();
  const Eigen::Vector3d turn = uncertainty.turn * way.tail<3>();
  if (turn.norm() > 0) X.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * X_WB.linear();
  return X;
}

/// Returns the candidates that the arm can touch with its base at X_WB.
std::vector<TouchPlan> touchedFrom(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                   const std::vector<TouchPlan>& candidates) {
  std::vector<Eigen::Vector3d> holes_W;
  std::vector<Eigen::VectorXd> starts;
  for (const TouchPlan& candidate : candidates) {
    holes_W.push_back(candidate.p_WH);
    starts.push_back(candidate.q_start);
  }
  const TouchSimulationOptions usual;
  const auto branches = reachPlaces(arm, X_WB, holes_W, starts, usual.load, usual.axis_W);
  std::vector<TouchPlan> touched;
  for (std::size_t k = 0; k < candidates.size(); ++k)
    if (branches[k].status == deflection::BranchStatus::kConverged) touched.push_back(candidates[k]);
  return touched;
}

}  // namespace

std::vector<TouchPlan> keepTouchable(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                     const std::vector<TouchPlan>& candidates, const BaseUncertainty& uncertainty) {
  std::vector<TouchPlan> kept = touchedFrom(arm, X_WB, candidates);
  for (const Vector6& way : waysOff()) kept = touchedFrom(arm, displaced(X_WB, way, uncertainty), kept);
  return kept;
}

std::vector<TouchPlan> robustlyTouchable(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                         const std::vector<TouchPlan>& candidates, int count) {
  auto kept = keepTouchable(arm, X_WB, candidates);
  return static_cast<int>(kept.size()) < count ? candidates : kept;
}

}  // namespace tubeplan::calibration
