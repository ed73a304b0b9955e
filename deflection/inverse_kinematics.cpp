#include "deflection/inverse_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "deflection/tip_differentiation.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;
constexpr double kTurn = 2 * std::numbers::pi;

/// Residual of the goal and its Jacobian by the joints.
struct GoalResidual {
  VectorXd value;
  MatrixXd jacobian;
  double position_error = 0, tilt = 0, pitch = 0;
};

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

class GoalProblem {
 public:
  GoalProblem(const Arm& arm, const ToolGoal& goal, double load, const Vector3d& gravity_B,
              const InverseKinematicsOptions& options)
      : arm_(arm),
        goal_(goal),
        load_(load),
        gravity_B_(gravity_B),
        options_(options),
        turret_(isTurretArm(arm)),
        reach_(reachOf(arm)),
        variables_(jointVariables(arm)),
        tip_(arm) {}

  bool exact() const { return turret_; }
  double reach() const { return reach_; }

  GoalResidual evaluate(const VectorXd& q) {
    tip_.solve({q, load_, gravity_B_}, variables_, options_.kinematics);
    return turret_ ? turretResidual(arm_, goal_, tip_, reach_) : poseResidual(arm_, goal_, tip_, options_);
  }

 private:
  const Arm& arm_;
  const ToolGoal& goal_;
  double load_;
  Vector3d gravity_B_;
  const InverseKinematicsOptions& options_;
  bool turret_;
  double reach_;
  std::vector<Variable> variables_;
  TipDifferentiation tip_;
};

double smallestSingularValue(const GoalResidual& r, double reach) {
  return Eigen::JacobiSVD<MatrixXd>(r.jacobian / reach).singularValues().minCoeff();
}

bool reached(const GoalResidual& r, const VectorXd& step, bool exact, const InverseKinematicsOptions& options) {
  if (!exact) return step.norm() < 1e-11;
  return r.position_error < options.position_tolerance && std::abs(r.pitch) < options.pitch_tolerance &&
         r.tilt < kTurn / 4;
}

/// Newton where square, Gauss-Newton otherwise; halved until the residual falls.
Branch dampedNewton(GoalProblem& problem, VectorXd q, const InverseKinematicsOptions& options) {
  Branch branch;
  GoalResidual r = problem.evaluate(q);
  VectorXd step = VectorXd::Constant(q.size(), 1);
  for (branch.iterations = 0; branch.iterations < options.max_iterations && r.value.allFinite(); ++branch.iterations) {
    if (reached(r, step, problem.exact(), options)) {
      branch.status = BranchStatus::kConverged;
      break;
    }
    step = -r.jacobian.completeOrthogonalDecomposition().solve(r.value);
    const double longest = step.cwiseAbs().maxCoeff();
    if (longest > 0.5) step *= 0.5 / longest;
    GoalResidual next = problem.evaluate(q + step);
    double damping = 1;
    while (!(next.value.norm() < r.value.norm()) && damping > 1e-4 && step.norm() * damping > 1e-12) {
      damping /= 2;
      next = problem.evaluate(q + damping * step);
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

/// Brings each revolute reading into its limits by whole turns where that is possible, and names the one that is not.
std::string wrapIntoLimits(const Arm& arm, VectorXd& q) {
  const auto active = activeRows(arm);
  for (int k = 0; k < q.size(); ++k) {
    const auto& joint = arm.rows[active[k]].joint;
    if (joint.type == JointType::kRevolute) {
      q[k] = std::remainder(q[k], kTurn);
      if (q[k] < joint.lower && q[k] + kTurn <= joint.upper) q[k] += kTurn;
      if (q[k] > joint.upper && q[k] - kTurn >= joint.lower) q[k] -= kTurn;
    }
    if (q[k] < joint.lower || q[k] > joint.upper) return joint.name;
  }
  return {};
}

void judge(const Arm& arm, bool exact, const InverseKinematicsOptions& options, Branch& branch) {
  if (branch.status != BranchStatus::kConverged) {
    const bool flat = branch.smallest_singular_value < options.singular_floor;
    branch.status = flat ? BranchStatus::kSingular : BranchStatus::kNotConverged;
    branch.reason = flat ? "the arm is stretched or folded: smallest singular value below the floor"
                         : "Newton's method did not reach the goal";
    return;
  }
  const std::string joint = wrapIntoLimits(arm, branch.q);
  if (!joint.empty()) {
    branch.status = BranchStatus::kPastJointLimit;
    branch.reason = "past the limit of joint " + joint;
  } else if (exact && branch.smallest_singular_value < options.singular_floor) {
    branch.status = BranchStatus::kSingular;
    branch.reason = "the arm is stretched or folded: smallest singular value below the floor";
  } else if (!exact && branch.position_error > 1e-6) {
    branch.status = BranchStatus::kOutOfReach;
    branch.reason = "the goal is out of reach of this branch";
  }
}

bool isSameBranch(const VectorXd& a, const VectorXd& b) {
  return ((a - b).unaryExpr([](double d) { return std::remainder(d, kTurn); })).cwiseAbs().maxCoeff() < 1e-4;
}

int severity(BranchStatus status) {
  switch (status) {
    case BranchStatus::kConverged:
      return 0;
    case BranchStatus::kPastJointLimit:
      return 1;
    case BranchStatus::kSingular:
      return 2;
    case BranchStatus::kNotConverged:
      return 3;
    default:
      return 4;
  }
}

void summarise(InverseKinematics& result) {
  std::stable_sort(result.branches.begin(), result.branches.end(),
                   [](const Branch& a, const Branch& b) { return severity(a.status) < severity(b.status); });
  if (result.branches.empty()) {
    result.status = BranchStatus::kOutOfReach;
    result.reason = "the place is out of the arm's reach";
    return;
  }
  result.status = result.branches.front().status;
  result.reason = result.branches.front().reason;
}

}  // namespace

const char* nameOf(BranchStatus status) {
  switch (status) {
    case BranchStatus::kNotRun:
      return "not-run";
    case BranchStatus::kConverged:
      return "converged";
    case BranchStatus::kOutOfReach:
      return "out-of-reach";
    case BranchStatus::kPastJointLimit:
      return "past-joint-limit";
    case BranchStatus::kSingular:
      return "singular";
    case BranchStatus::kNotConverged:
      return "not-converged";
  }
  return "";
}

Branch refineBranch(const Arm& arm, const ToolGoal& goal, double load, const Vector3d& gravity_B, const VectorXd& start,
                    const InverseKinematicsOptions& options) {
  GoalProblem problem(arm, goal, load, gravity_B, options);
  Branch branch = dampedNewton(problem, start, options);
  if (!arm.effects.empty()) {
    // A reading that an effect scales is not the same place a whole turn further: it is solved for again there.
    VectorXd wrapped = branch.q;
    wrapIntoLimits(arm, wrapped);
    if (branch.status == BranchStatus::kConverged && wrapped != branch.q)
      branch = dampedNewton(problem, wrapped, options);
  }
  judge(arm, problem.exact(), options, branch);
  return branch;
}

InverseKinematics solveInverseKinematics(const Arm& arm, const ToolGoal& goal, double load, const Vector3d& gravity_B,
                                         const InverseKinematicsOptions& options) {
  InverseKinematics result;
  const bool turret = isTurretArm(arm);
  const auto starts = turret ? turretBranches(arm, goal) : latticeStarts(arm, options.lattice_starts);
  for (const auto& start : starts) {
    Branch branch = refineBranch(arm, goal, load, gravity_B, start, options);
    const bool known = std::any_of(result.branches.begin(), result.branches.end(),
                                   [&](const Branch& other) { return isSameBranch(other.q, branch.q); });
    if (!known && (turret || branch.status != BranchStatus::kNotConverged)) result.branches.push_back(branch);
  }
  summarise(result);
  return result;
}

}  // namespace tubeplan::deflection
