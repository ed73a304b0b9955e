#include "deflection/inverse_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "deflection/hinges/hinge_chain.hpp"
#include "deflection/hinges/kernels.hpp"
#include "deflection/inverse_solver.hpp"
#include "deflection/tip_differentiation.hpp"
#include "deflection/turret_branches.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;
constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kStraightSteps = 12;  ///< without damping; a goal that takes more is met alone

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

/// The residual of one goal after the other.
class GoalProblem {
 public:
  GoalProblem(const Arm& arm, bool turret, double load, const Vector3d& gravity_B,
              const InverseKinematicsOptions& options)
      : arm_(arm),
        load_(load),
        gravity_B_(gravity_B),
        options_(options),
        turret_(turret),
        reach_(reachOf(arm)),
        variables_(jointVariables(arm)),
        tip_(arm) {}

  bool exact() const { return turret_; }
  double reach() const { return reach_; }

  GoalResidual evaluate(const ToolGoal& goal, const VectorXd& q) {
    tip_.solve({q, load_, gravity_B_}, variables_, options_.kinematics);
    return turret_ ? turretResidual(arm_, goal, tip_, reach_) : poseResidual(arm_, goal, tip_, options_);
  }

 private:
  const Arm& arm_;
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

/// Brings each revolute reading into its limits by whole turns where that is possible, and names the one that is not.
std::string wrapIntoLimits(const Arm& arm, VectorXd& q) {
  Eigen::Index k = 0;
  for (const auto& row : arm.rows) {
    const auto& joint = row.joint;
    if (joint.type == JointType::kPassive) continue;
    if (joint.type == JointType::kRevolute) {
      q[k] = std::remainder(q[k], kTurn);
      if (q[k] < joint.lower && q[k] + kTurn <= joint.upper) q[k] += kTurn;
      if (q[k] > joint.upper && q[k] - kTurn >= joint.lower) q[k] -= kTurn;
    }
    if (q[k] < joint.lower || q[k] > joint.upper) return joint.name;
    ++k;
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

namespace {

hinges::Tool toolOf(const Arm& arm, const hinges::HingeChain& chain) {
  const hinges::TurnDirection& last = chain.lastAxis();
  hinges::Tool tool{{}, last.turn, {}};
  std::copy_n(arm.tool_axis_L.data(), 3, tool.axis);
  std::copy_n(last.direction.data(), 3, tool.hand_axis);
  return tool;
}

void setLane(const ToolGoal& goal, const VectorXd& start, std::size_t lane, hinges::Goals& lanes) {
  for (int axis = 0; axis < 3; ++axis) {
    lanes.p_BT[axis][lane] = goal.p_BT[axis];
    lanes.axis_B[axis][lane] = goal.axis_B[axis];
  }
  for (int j = 0; j < 4; ++j) lanes.start[j][lane] = start[j];
}

Branch branchOf(const hinges::Reached& reached, std::size_t lane) {
  Branch branch;
  if (reached.done[lane] == 1) branch.status = BranchStatus::kConverged;
  branch.q = Eigen::Vector4d(reached.q[0][lane], reached.q[1][lane], reached.q[2][lane], reached.q[3][lane]);
  branch.position_error = reached.position_error[lane];
  branch.tilt = std::atan2(reached.tilt_sine[lane], reached.tilt_cosine[lane]);
  branch.smallest_singular_value = reached.smallest_singular_value[lane];
  branch.iterations = static_cast<int>(reached.steps[lane]);
  return branch;
}

}  // namespace

/// What leads starts to their goals: kernels where they can, else one by one.
class InverseSolver::Parts {
 public:
  Parts(const Arm& arm, double load, const Vector3d& gravity_B, const InverseKinematicsOptions& asked)
      : options(asked), branches(arm), arm_(arm), load_(load), gravity_B_(gravity_B), prepared_(arm) {}

  /// Each start led to its goal.
  std::vector<Branch> lead(std::span<const ToolGoal> goals, std::span<const VectorXd> starts) {
    std::vector<Branch> found(goals.size());
    std::vector<std::size_t> open(goals.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    const hinges::HingeChain* chain = prepared_.hinges();
    // Most goals are met straight away; those that are not would keep their neighbours waiting.
    if (branches.isTurret() && chain && chain->hasJacobian())
      for (const bool damped : {false, true}) open = leadSideBySide(*chain, goals, starts, open, damped, found);
    for (const std::size_t k : open) found[k] = leadAlone(goals[k], starts[k]);
    for (Branch& branch : found) judge(arm_, branches.isTurret(), options, branch);
    return found;
  }

  const InverseKinematicsOptions options;
  const RigidBranches branches;

 private:
  /// Those of `which` that a kernel leads to their goals or as near as they come; returns the others.
  std::vector<std::size_t> leadSideBySide(const hinges::HingeChain& chain, std::span<const ToolGoal> goals,
                                          std::span<const VectorXd> starts, std::span<const std::size_t> which,
                                          bool damped, std::vector<Branch>& found);
  hinges::Goals goalsFor(const hinges::HingeArm& numbers, bool damped) const;
  Branch leadAlone(const ToolGoal& goal, const VectorXd& start);

  const Arm& arm_;
  double load_;
  Vector3d gravity_B_;
  PreparedArm prepared_;
  std::optional<GoalProblem> problem_;  ///< made when a kernel leaves something over
};

std::vector<std::size_t> InverseSolver::Parts::leadSideBySide(const hinges::HingeChain& chain,
                                                              std::span<const ToolGoal> goals,
                                                              std::span<const VectorXd> starts,
                                                              std::span<const std::size_t> which, bool damped,
                                                              std::vector<Branch>& found) {
  const hinges::HingeArm numbers = chain.numbers();
  const hinges::Tool tool = toolOf(arm_, chain);
  hinges::Goals lanes = goalsFor(numbers, damped);
  hinges::Reached reached{};
  std::vector<std::size_t> open;
  for (std::size_t first = 0; first < which.size();) {
    const hinges::Kernel& kernel = hinges::kernelFor(static_cast<int>(which.size() - first));
    const std::size_t width = static_cast<std::size_t>(kernel.lanes), count = std::min(which.size() - first, width);
    for (std::size_t l = 0; l < width; ++l) {
      const std::size_t k = which[first + std::min(l, count - 1)];
      setLane(goals[k], starts[k], l, lanes);
    }
    kernel.meet(numbers, tool, lanes, reached);
    for (std::size_t l = 0; l < count; ++l) {
      if (reached.done[l] == 0)
        open.push_back(which[first + l]);
      else
        found[which[first + l]] = branchOf(reached, l);
    }
    first += count;
  }
  return open;
}

hinges::Goals InverseSolver::Parts::goalsFor(const hinges::HingeArm& numbers, bool damped) const {
  hinges::Goals lanes{};
  lanes.tolerance = options.kinematics.tolerance * numbers.reach;
  lanes.position_tolerance = options.position_tolerance;
  lanes.pitch_tolerance = options.pitch_tolerance;
  lanes.max_sweeps = options.kinematics.max_iterations;
  lanes.damped = damped;
  lanes.max_steps = damped ? options.max_iterations : std::min(options.max_iterations, kStraightSteps);
  for (std::size_t l = 0; l < 8; ++l) {
    lanes.load[l] = load_;
    for (int axis = 0; axis < 3; ++axis) lanes.gravity_B[axis][l] = gravity_B_[axis];
  }
  return lanes;
}

Branch InverseSolver::Parts::leadAlone(const ToolGoal& goal, const VectorXd& start) {
  if (!problem_) problem_.emplace(arm_, branches.isTurret(), load_, gravity_B_, options);
  Branch branch = dampedNewton(*problem_, goal, start, options);
  if (arm_.effects.empty() || branch.status != BranchStatus::kConverged) return branch;
  // A reading that an effect scales is not the same place a whole turn further: it is solved for again there.
  VectorXd wrapped = branch.q;
  wrapIntoLimits(arm_, wrapped);
  return wrapped == branch.q ? branch : dampedNewton(*problem_, goal, wrapped, options);
}

InverseSolver::InverseSolver(const Arm& arm, double load, const Vector3d& gravity_B,
                             const InverseKinematicsOptions& options)
    : parts_(std::make_unique<Parts>(arm, load, gravity_B, options)) {}

InverseSolver::~InverseSolver() = default;

std::vector<Branch> InverseSolver::refine(std::span<const ToolGoal> goals, std::span<const VectorXd> starts) {
  return parts_->lead(goals, starts);
}

std::vector<InverseKinematics> InverseSolver::solve(std::span<const ToolGoal> goals) {
  std::vector<ToolGoal> goal_of;
  std::vector<VectorXd> starts;
  std::vector<std::size_t> ends;
  for (const ToolGoal& goal : goals) {
    parts_->branches.addStarts(goal, parts_->options.lattice_starts, starts);
    goal_of.resize(starts.size(), goal);
    ends.push_back(starts.size());
  }
  std::vector<Branch> found = parts_->lead(goal_of, starts);
  std::vector<InverseKinematics> results(goals.size());
  for (std::size_t g = 0, k = 0; g < goals.size(); ++g) {
    auto& branches = results[g].branches;
    branches.reserve(parts_->branches.isTurret() ? ends[g] - k : 0);
    for (; k < ends[g]; ++k) {
      Branch& branch = found[k];
      const bool known = std::any_of(branches.begin(), branches.end(),
                                     [&](const Branch& other) { return isSameBranch(other.q, branch.q); });
      if (!known && (parts_->branches.isTurret() || branch.status != BranchStatus::kNotConverged))
        branches.push_back(std::move(branch));
    }
    summarise(results[g]);
  }
  return results;
}

InverseKinematics InverseSolver::solve(const ToolGoal& goal) { return std::move(solve(std::span(&goal, 1)).front()); }

Branch refineBranch(const Arm& arm, const ToolGoal& goal, double load, const Vector3d& gravity_B, const VectorXd& start,
                    const InverseKinematicsOptions& options) {
  return InverseSolver(arm, load, gravity_B, options).refine(std::span(&goal, 1), std::span(&start, 1)).front();
}

InverseKinematics solveInverseKinematics(const Arm& arm, const ToolGoal& goal, double load, const Vector3d& gravity_B,
                                         const InverseKinematicsOptions& options) {
  return InverseSolver(arm, load, gravity_B, options).solve(goal);
}

}  // namespace tubeplan::deflection
