#include "deflection/inverse/goal_newton.hpp"

#include <cmath>
#include <numbers>

#include "deflection/free_motion.hpp"
#include "deflection/rotation.hpp"
#include "deflection/tip_differentiation.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;
constexpr double kPlaceFloor = 1e-4;  ///< of the place's slopes, per reach: what is below is no motion
constexpr double kPlaceWeight = 10;   ///< of the place, in reaches, against the lean in rad, where a step is judged
constexpr double kLimitWeight = 2;    ///< of what is past limits, scaled
constexpr double kWithin = 0.02;      ///< scaled, where a joint is led to that was past its limit
constexpr double kIntoLimits = 1e-3;  ///< scaled; a step into the limits that is shorter ends
constexpr double kLongestStep = 0.5;  ///< scaled
constexpr int kMostStrikes = 4;       ///< steps that lead no nearer however short, before the start is given up

/// The pitch of a turret arm: the tilt about the axis h of its last joint, which rides with the tool.
void addPitch(const Vector3d& n, const TipMotion& tip, GoalResidual& out) {
  const Vector3d &t = tip.axis, &h = tip.last_axis;
  out.lean.resize(1);
  out.lean[0] = h.dot(t.cross(n));
  out.by_lean.resize(1, tip.columns.cols());
  for (Index k = 0; k < tip.columns.cols(); ++k) {
    const Vector3d w = tip.columns.col(k).tail<3>();
    out.by_lean(0, k) = w.cross(h).dot(t.cross(n)) + h.dot(w.cross(t).cross(n));
  }
}

/// The turn that leads the tool's axis to the goal's, about two directions across the tool.
void addLean(const Vector3d& n, const TipMotion& tip, GoalResidual& out) {
  const Vector3d t = tip.axis, across = t.cross(n);
  const double sine = across.norm();
  // Of a tool that points the other way any turn across it will do.
  const Vector3d u = sine > 1e-12 ? Vector3d(across / sine) : Vector3d(t.unitOrthogonal()), v = t.cross(u);
  out.lean.resize(2);
  out.lean << out.tilt, 0;
  out.by_lean.resize(2, tip.columns.cols());
  out.by_lean.row(0) = -u.transpose() * tip.columns.bottomRows<3>();
  out.by_lean.row(1) = -v.transpose() * tip.columns.bottomRows<3>();
}

double smallestSingularValue(const GoalResidual& r, bool with_lean) {
  MatrixXd held(with_lean ? r.by_off.rows() + r.by_lean.rows() : r.by_off.rows(), r.by_off.cols());
  held.topRows(r.by_off.rows()) = r.by_off;
  if (with_lean) held.bottomRows(r.by_lean.rows()) = r.by_lean;
  return Eigen::JacobiSVD<MatrixXd>(held).singularValues().minCoeff();
}

struct GoalStep {
  VectorXd joints;         ///< scaled
  double lean = 0;         ///< rad that it takes from the lean
  double into_limits = 0;  ///< scaled, of it for the limits' sake
};

GoalStep stepFrom(const GoalProblem& problem, const GoalResidual& r, const VectorXd& q) {
  GoalStep step;
  FreeMotion free(q.size());
  step.joints = free.take(r.by_off, -r.off, kPlaceFloor);
  const VectorXd lean = -r.lean - r.by_lean * step.joints;
  const VectorXd upright =
      free.take(r.by_lean, lean, problem.isTurret() ? kPlaceFloor : problem.options().singular_floor);
  step.joints += upright;
  step.lean = (r.by_lean * upright).norm();
  const VectorXd past = problem.pastLimits(q);
  const Index count = (past.array() != 0).count();
  if (count == 0) return step;
  MatrixXd which = MatrixXd::Zero(count, q.size());
  VectorXd wanted(count);
  for (Index k = 0, row = 0; k < q.size(); ++k)
    if (past[k] != 0) which(row, k) = 1, wanted[row++] = -past[k] - step.joints[k];
  const VectorXd back = free.take(which, wanted, 0.1);
  step.joints += back;
  step.into_limits = back.norm();
  return step;
}

bool isMet(const GoalProblem& problem, const GoalResidual& r, const GoalStep& step) {
  const InverseKinematicsOptions& options = problem.options();
  const double lean = problem.isTurret() ? std::abs(r.lean[0]) : step.lean;
  return r.position_error < options.position_tolerance && lean < options.pitch_tolerance &&
         step.into_limits < kIntoLimits && (!problem.isTurret() || r.tilt < std::numbers::pi / 2);
}

}  // namespace

PlaceTip deflectedTip(const Arm& arm, double load, const Vector3d& gravity_B,
                      const FlexibleKinematicsOptions& options) {
  auto tip = std::make_shared<TipDifferentiation>(arm);
  const int last = activeRows(arm).back();
  return [=, tool_axis_L = arm.tool_axis_L, variables = jointVariables(arm)](const VectorXd& q, TipMotion& out) {
    out.is_converged = tip->solve({q, load, gravity_B}, variables, options) == KinematicsStatus::kConverged;
    out.p = tip->arm().X_BD().p;
    out.axis = tip->arm().X_BD().R * tool_axis_L;
    out.last_axis = tip->arm().X_BL(last).R.col(2);
    out.columns = tip->columns();
  };
}

GoalProblem::GoalProblem(const Arm& arm, bool turret, PlaceTip place, const InverseKinematicsOptions& options)
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

void GoalProblem::evaluate(const ToolGoal& goal, const VectorXd& q, GoalResidual& out) {
  place_(q, tip_);
  const Vector3d &t = tip_.axis, &n = goal.axis_B;
  const Vector3d off = tip_.p - goal.p_BT;
  out.position_error = off.norm();
  out.tilt = std::atan2(t.cross(n).norm(), t.dot(n));
  out.off = off / reach_;
  tip_.columns = tip_.columns * scale_.asDiagonal();
  out.by_off = tip_.columns.topRows<3>() / reach_;
  turret_ ? addPitch(n, tip_, out) : addLean(n, tip_, out);
}

VectorXd GoalProblem::pastLimits(const VectorXd& q) const {
  VectorXd past = VectorXd::Zero(q.size());
  for (Index k = 0; k < q.size(); ++k) {
    double at = q[k];
    if (at >= lower_[k] && at <= upper_[k]) continue;
    const double middle = (lower_[k] + upper_[k]) / 2,
                 within = std::min(kWithin * scale_[k], (upper_[k] - lower_[k]) / 4);
    if (scale_[k] == 1 && std::isfinite(middle)) at = middle + std::remainder(at - middle, kFullTurn);
    if (at > upper_[k]) past[k] = (at - upper_[k] + within) / scale_[k];
    if (at < lower_[k]) past[k] = (at - lower_[k] - within) / scale_[k];
  }
  return past;
}

namespace {

/// What a posture is judged by on the way.
double meritOf(const GoalProblem& problem, const GoalResidual& r, const VectorXd& q) {
  return kPlaceWeight * r.off.norm() + r.lean.norm() + kLimitWeight * problem.pastLimits(q).norm();
}

/// Takes a step, or as much of it as leads nearer; false where even the shortest leads nowhere.
bool advance(GoalProblem& problem, const ToolGoal& goal, const VectorXd& step, VectorXd& q, GoalResidual& r) {
  const double merit = meritOf(problem, r, q), longest = step.cwiseAbs().maxCoeff();
  const VectorXd whole = problem.scale().cwiseProduct(step) * (longest > kLongestStep ? kLongestStep / longest : 1);
  GoalResidual next;
  VectorXd there;
  for (double share = 1; share > 0.1; share /= 2) {
    there = q + share * whole;
    problem.evaluate(goal, there, next);
    if (!(meritOf(problem, next, there) < merit)) continue;
    q = there;
    r = std::move(next);
    return true;
  }
  if (!next.isFinite()) return false;
  q = there;
  r = std::move(next);
  return false;
}

}  // namespace

Branch leadToGoal(GoalProblem& problem, const ToolGoal& goal, VectorXd q) {
  Branch branch;
  GoalResidual r;
  problem.evaluate(goal, q, r);
  for (int strikes = 0; branch.iterations < problem.options().max_iterations && r.isFinite(); ++branch.iterations) {
    const GoalStep step = stepFrom(problem, r, q);
    if (isMet(problem, r, step)) {
      branch.status = BranchStatus::kConverged;
      break;
    }
    if (!advance(problem, goal, step.joints, q, r) && ++strikes == kMostStrikes) break;
  }
  branch.q = q;
  branch.position_error = r.position_error;
  branch.tilt = r.tilt;
  if (r.isFinite()) branch.smallest_singular_value = smallestSingularValue(r, problem.isTurret());
  return branch;
}

}  // namespace tubeplan::deflection
