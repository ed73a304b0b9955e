#include "deflection/inverse/goal_problem.hpp"

#include <cmath>
#include <memory>

#include "deflection/kinematics.hpp"
#include "deflection/resized.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;
/// Joints beyond a limit are moved this far inside it [rad or fraction of the reach].
constexpr double kWithin = 0.02;

/// Adds the pitch residual of a turret arm: the tilt about the axis h of the last joint, which moves with the tool.
void addPitch(const Vector3d& n, const TipMotion& tip, GoalResidual& out) {
  const Vector3d &t = tip.axis, &h = tip.last_axis;
  out.lean.resize(1);
  out.lean[0] = h.dot(t.cross(n));
  resizeOrEmpty(out.by_lean, 1, tip.columns.cols());
  for (Index k = 0; k < tip.columns.cols(); ++k) {
    const Vector3d w = tip.columns.col(k).tail<3>();
    out.by_lean(0, k) = w.cross(h).dot(t.cross(n)) + h.dot(w.cross(t).cross(n));
  }
}

/// Adds the direction residual of other arms: the rotation from the tool axis to the goal axis, about two directions
/// perpendicular to the tool axis.
void addLean(const Vector3d& n, const TipMotion& tip, GoalResidual& out) {
  const Vector3d t = tip.axis, across = t.cross(n);
  const double sine = across.norm();
  // If tool axis and goal axis are parallel or opposite, any perpendicular direction is a valid rotation axis.
  const Vector3d u = sine > 1e-12 ? Vector3d(across / sine) : Vector3d(t.unitOrthogonal()), v = t.cross(u);
  out.lean.resize(2);
  out.lean << out.tilt, 0;
  resizeOrEmpty(out.by_lean, 2, tip.columns.cols());
  out.by_lean.row(0).noalias() = -u.transpose().lazyProduct(tip.columns.bottomRows<3>());
  out.by_lean.row(1).noalias() = -v.transpose().lazyProduct(tip.columns.bottomRows<3>());
}

/// Returns the function that computes tips of a turret arm together with their `last_axis`, which TipBatch does not
/// contain.
PlaceTips turretTips(const Arm& arm, double load, const Vector3d& gravity_B, const FlexibleKinematicsOptions& options) {
  auto tip = std::make_shared<TipDifferentiation>(arm);
  const int last = activeRows(arm).back();
  return [=, tool_axis_L = arm.tool_axis_L, variables = jointVariables(arm)](const Eigen::Ref<const MatrixXd>& q,
                                                                             std::span<TipMotion> tips) {
    for (std::size_t k = 0; k < tips.size(); ++k) {
      TipMotion& out = tips[k];
      out.is_converged = tip->solve({q.col(static_cast<Index>(k)), load, gravity_B}, variables, options) ==
                         KinematicsStatus::kConverged;
      out.p = tip->arm().X_BD().p;
      out.axis = tip->arm().X_BD().R * tool_axis_L;
      out.last_axis = tip->arm().X_BL(last).R.col(2);
      out.columns = tip->columns();
    }
  };
}

}  // namespace

PlaceTips deflectedTips(const Arm& arm, bool turret, double load, const Vector3d& gravity_B,
                        const FlexibleKinematicsOptions& options) {
  if (turret) return turretTips(arm, load, gravity_B, options);
  struct Work {
    explicit Work(const Arm& arm) : kinematics(arm) {}
    Kinematics kinematics;
    PostureBatch postures;
    TipBatch tips;
  };
  auto work = std::make_shared<Work>(arm);
  return [=, tool_axis_L = arm.tool_axis_L](const Eigen::Ref<const MatrixXd>& q, std::span<TipMotion> tips) {
    const Index count = q.cols();
    work->postures.resize(q.rows(), count, load, gravity_B);
    work->postures.q = q;
    work->kinematics.solveWithJacobian(work->postures, work->tips, options);
    for (Index k = 0; k < count; ++k) {
      TipMotion& out = tips[static_cast<std::size_t>(k)];
      out.is_converged = work->tips.status[static_cast<std::size_t>(k)] == KinematicsStatus::kConverged;
      const auto X = work->tips.X_BD(k);
      out.p = X.p;
      out.axis = X.R * tool_axis_L;
      resizeOrEmpty(out.columns, 6, q.rows());
      out.columns.reshaped() = work->tips.jacobian.col(k);
    }
  };
}

PlaceTips rigidTips(const AxesAtZero& axes) {
  return [&axes](const Eigen::Ref<const MatrixXd>& q, std::span<TipMotion> tips) {
    for (std::size_t k = 0; k < tips.size(); ++k) placeRigidTip(axes, q.col(static_cast<Index>(k)), tips[k]);
  };
}

GoalProblem::GoalProblem(const Arm& arm, bool turret, PlaceTips place, const InverseKinematicsOptions& options)
    : turret_(turret), place_(std::move(place)), options_(options), reach_(reachOf(arm)) {
  const auto n = arm.jointCount();
  scale_ = lower_ = upper_ = VectorXd::Ones(n);
  for (Index k = 0; k < n; ++k) {
    const auto& joint = arm.joint(k);
    if (joint.type == JointType::kPrismatic) scale_[k] = reach_;
    lower_[k] = joint.lower;
    upper_[k] = joint.upper;
  }
}

void GoalProblem::evaluate(const ToolGoal& goal, TipMotion& tip, GoalResidual& out) const {
  const Vector3d &t = tip.axis, &n = goal.axis_B;
  const Vector3d off = tip.p - goal.p_BT;
  out.position_error = off.norm();
  out.tilt = std::atan2(t.cross(n).norm(), t.dot(n));
  out.off = off / reach_;
  for (Index k = 0; k < scale_.size(); ++k) tip.columns.col(k) *= scale_[k];
  out.by_off = tip.columns.topRows<3>() / reach_;
  turret_ ? addPitch(n, tip, out) : addLean(n, tip, out);
}

double GoalProblem::pastLimit(Index k, double at) const {
  if (at >= lower_[k] && at <= upper_[k]) return 0;
  const double middle = (lower_[k] + upper_[k]) / 2,
               within = std::min(kWithin * scale_[k], (upper_[k] - lower_[k]) / 4);
  if (scale_[k] == 1 && std::isfinite(middle) && std::abs(at - middle) > kFullTurn / 2)
    at = middle + std::remainder(at - middle, kFullTurn);
  if (at > upper_[k]) return (at - upper_[k] + within) / scale_[k];
  if (at < lower_[k]) return (at - lower_[k] - within) / scale_[k];
  return 0;
}

double GoalProblem::mostPastLimits(const Eigen::Ref<const VectorXd>& q) const {
  double most = 0;
  for (Index k = 0; k < q.size(); ++k) most = std::max(most, std::abs(pastLimit(k, q[k])));
  return most;
}

}  // namespace tubeplan::deflection
