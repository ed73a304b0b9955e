#include "calibration/touch_reserve.hpp"

#include <cmath>

#include "deflection/inverse_solver.hpp"

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

/// Whether the arm, standing at X_WB, can touch each of the candidates.
std::vector<bool> areTouched(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                             const std::vector<TouchPlan>& candidates) {
  std::vector<deflection::ToolGoal> goals;
  std::vector<Eigen::VectorXd> starts;
  for (const TouchPlan& candidate : candidates) {
    goals.push_back({X_WB.inverse() * candidate.p_WH, X_WB.linear().transpose() * TouchSimulationOptions{}.axis_W});
    starts.push_back(candidate.q_start);
  }
  deflection::InverseSolver solver(arm, 0, deflection::gravityInBase(arm, X_WB));
  std::vector<bool> touched;
  for (const auto& branch : solver.refine(goals, starts))
    touched.push_back(branch.status == deflection::BranchStatus::kConverged);
  return touched;
}

}  // namespace

std::vector<TouchPlan> keepTouchable(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                     const std::vector<TouchPlan>& candidates, const BaseDoubt& doubt) {
  std::vector<TouchPlan> kept = candidates;
  for (const Vector6& way : waysOff()) {
    const auto touched = areTouched(arm, displaced(X_WB, way, doubt), kept);
    std::erase_if(kept, [&](const TouchPlan& candidate) {
      return !touched[static_cast<std::size_t>(&candidate - kept.data())];
    });
  }
  return kept;
}

}  // namespace tubeplan::calibration
