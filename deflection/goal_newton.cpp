#include "deflection/goal_newton.hpp"

#include <cmath>
#include <numbers>

namespace tubeplan::deflection {

namespace {

using Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

/// Position [m] and, scaled by the reach, the tilt about the last joint's axis h: h . (t x n) = 0.
GoalResidual turretResidual(const Arm& arm, const ToolGoal& goal, const TipDifferentiation& tip, double reach) {
  GoalResidual out;
  const auto& X = tip.arm().X_BD();
  const Vector3d t = X.R * arm.tool_axis_L, &n = goal.axis_B;
  // The axis of the last joint, which rides with the tool: the only turn left to that joint is about it.
  const Vector3d h = tip.arm().X_BL(activeRows(arm).back()).R.col(2);
  const Vector3d off = X.p - goal.p_BT;
  out.position_error = off.norm();
  out.tilt = std::atan2(t.cross(n).norm(), t.dot(n));
  out.pitch = h.dot(t.cross(n));
  out.value.resize(4);
  out.value << off, reach * out.pitch;
  out.jacobian.resize(4, tip.columns().cols());
  out.jacobian.topRows(3) = tip.columns().topRows<3>();
  for (int k = 0; k < tip.columns().cols(); ++k) {
    const Vector3d w = tip.columns().col(k).tail<3>();
    out.jacobian(3, k) = reach * (w.cross(h).dot(t.cross(n)) + h.dot(w.cross(t).cross(n)));
  }
  return out;
}

/// Weighted position and axis error, for arms that cannot meet both.
GoalResidual poseResidual(const Arm& arm, const ToolGoal& goal, const TipDifferentiation& tip,
                          const InverseKinematicsOptions& options) {
  GoalResidual out;
  const auto& X = tip.arm().X_BD();
  const Vector3d t = X.R * arm.tool_axis_L, &n = goal.axis_B;
  const Vector3d off = X.p - goal.p_BT;
  out.position_error = off.norm();
  out.tilt = std::atan2(t.cross(n).norm(), t.dot(n));
  out.value.resize(6);
  out.value << options.position_weight * off, options.axis_weight * (t - n);
  out.jacobian.resize(6, tip.columns().cols());
  out.jacobian.topRows(3) = options.position_weight * tip.columns().topRows<3>();
  for (int k = 0; k < tip.columns().cols(); ++k)
    out.jacobian.col(k).tail(3) = options.axis_weight * Vector3d(tip.columns().col(k).tail<3>()).cross(t);
  return out;
}

double smallestSingularValue(const GoalResidual& r, double reach) {
  return Eigen::JacobiSVD<MatrixXd>(r.jacobian / reach).singularValues().minCoeff();
}

bool reached(const GoalResidual& r, const VectorXd& step, bool exact, const InverseKinematicsOptions& options) {
  if (!exact) return step.norm() < 1e-11;
  return r.position_error < options.position_tolerance && std::abs(r.pitch) < options.pitch_tolerance &&
         r.tilt < std::numbers::pi / 2;
}

}  // namespace

GoalResidual GoalProblem::evaluate(const ToolGoal& goal, const VectorXd& q) {
  tip_.solve({q, load_, gravity_B_}, variables_, options_.kinematics);
  return turret_ ? turretResidual(arm_, goal, tip_, reach_) : poseResidual(arm_, goal, tip_, options_);
}

Branch dampedNewton(GoalProblem& problem, const ToolGoal& goal, VectorXd q, const InverseKinematicsOptions& options) {
  Branch branch;
  GoalResidual r = problem.evaluate(goal, q);
  VectorXd step = VectorXd::Constant(q.size(), 1);
  for (branch.iterations = 0; branch.iterations < options.max_iterations && r.value.allFinite(); ++branch.iterations) {
    if (reached(r, step, problem.exact(), options)) {
      branch.status = BranchStatus::kConverged;
      break;
    }
    step = -r.jacobian.completeOrthogonalDecomposition().solve(r.value);
    const double longest = step.cwiseAbs().maxCoeff();
    if (longest > 0.5) step *= 0.5 / longest;
    GoalResidual next = problem.evaluate(goal, q + step);
    double damping = 1;
    while (!(next.value.norm() < r.value.norm()) && damping > 1e-4 && step.norm() * damping > 1e-12) {
      damping /= 2;
      next = problem.evaluate(goal, q + damping * step);
    }
    const bool stuck = !(next.value.norm() < r.value.norm());
    if (stuck && problem.exact() && r.position_error > options.position_tolerance) break;
    q += damping * step;
    step *= damping;
    r = next;
    if (stuck && !problem.exact()) step.setZero();
  }
  branch.q = q;
  branch.position_error = r.position_error;
  branch.tilt = r.tilt;
  if (r.jacobian.allFinite()) branch.smallest_singular_value = smallestSingularValue(r, problem.reach());
  return branch;
}

}  // namespace tubeplan::deflection
