#include "deflection/inverse/inverse_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "deflection/inverse/branch_verdict.hpp"
#include "deflection/inverse/goal_newton.hpp"
#include "deflection/inverse/inverse_solver.hpp"
#include "deflection/inverse/start_postures.hpp"
#include "deflection/inverse/turret_branches.hpp"
#include "deflection/prepared_arm.hpp"
#include "deflection/revolute_chain/kernels.hpp"
#include "deflection/revolute_chain/revolute_chain.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::Vector3d, Eigen::VectorXd;
constexpr int kStraightSteps = 12;  ///< largest number of undamped steps; goals that need more are solved with damping

simd::Tool toolOf(const Arm& arm, const simd::RevoluteChain& chain) {
  const simd::TurnDirection& last = chain.lastAxis();
  simd::Tool tool{{}, last.turn, {}};
  std::copy_n(arm.tool_axis_L.data(), 3, tool.axis);
  std::copy_n(last.direction.data(), 3, tool.hand_axis);
  return tool;
}

void setLane(const ToolGoal& goal, const VectorXd& start, std::size_t lane, simd::Goals& lanes) {
  for (int axis = 0; axis < 3; ++axis) {
    lanes.p_BT[axis][lane] = goal.p_BT[axis];
    lanes.axis_B[axis][lane] = goal.axis_B[axis];
  }
  for (int j = 0; j < 4; ++j) lanes.start[j][lane] = start[j];
}

Branch branchOf(const simd::Reached& reached, std::size_t lane) {
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

/// The iteration from starts to goals: by kernels if possible, else by leadToGoals().
class InverseSolver::Parts {
 public:
  Parts(const Arm& arm, double load, const Vector3d& gravity_B, const InverseKinematicsOptions& given_options)
      : options(given_options), branches(arm, options), arm_(arm), load_(load), gravity_B_(gravity_B), prepared_(arm) {}

  /// Iterates from each start to its goal; returns the resulting branches with their verdicts.
  std::vector<Branch> lead(std::span<const ToolGoal> goals, std::span<const VectorXd> starts) {
    std::vector<Branch> found(goals.size());
    std::vector<std::size_t> open(goals.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    const simd::RevoluteChain* chain = prepared_.revoluteChain();
    // Most goals are met without damping. The others are solved in a second pass, because damped steps in one lane
    // would make the other lanes wait.
    if (branches.isTurret() && chain && chain->hasJacobian())
      for (const bool damped : {false, true}) open = leadSideBySide(*chain, goals, starts, open, damped, found);
    leadOthers(goals, starts, open, found);
    for (Branch& branch : found) judge(arm_, options, branch);
    return found;
  }

  const InverseKinematicsOptions options;
  StartPostures branches;

 private:
  /// Iterates with kernels from the starts with indices `which` to their goals. Returns the indices of the starts that
  /// the kernels abandoned.
  std::vector<std::size_t> leadSideBySide(const simd::RevoluteChain& chain, std::span<const ToolGoal> goals,
                                          std::span<const VectorXd> starts, std::span<const std::size_t> which,
                                          bool damped, std::vector<Branch>& found);
  simd::Goals goalsFor(const simd::RevoluteArm& numbers, bool damped) const;
  void leadOthers(std::span<const ToolGoal> goals, std::span<const VectorXd> starts, std::span<const std::size_t> which,
                  std::vector<Branch>& found);

  const Arm& arm_;
  double load_;
  Vector3d gravity_B_;
  PreparedArm prepared_;
  std::optional<GoalProblem> problem_;  ///< created when kernels first leave goals unsolved
};

std::vector<std::size_t> InverseSolver::Parts::leadSideBySide(const simd::RevoluteChain& chain,
                                                              std::span<const ToolGoal> goals,
                                                              std::span<const VectorXd> starts,
                                                              std::span<const std::size_t> which, bool damped,
                                                              std::vector<Branch>& found) {
  const simd::RevoluteArm numbers = chain.numbers();
  const simd::Tool tool = toolOf(arm_, chain);
  simd::Goals lanes = goalsFor(numbers, damped);
  simd::Reached reached{};
  std::vector<std::size_t> open;
  for (std::size_t first = 0; first < which.size();) {
    const simd::Kernel& kernel = simd::kernelFor(static_cast<int>(which.size() - first));
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

simd::Goals InverseSolver::Parts::goalsFor(const simd::RevoluteArm& numbers, bool damped) const {
  simd::Goals lanes{};
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

void InverseSolver::Parts::leadOthers(std::span<const ToolGoal> goals, std::span<const VectorXd> starts,
                                      std::span<const std::size_t> which, std::vector<Branch>& found) {
  if (which.empty()) return;
  if (!problem_) {
    const bool turret = branches.isTurret();
    problem_.emplace(arm_, turret, deflectedTips(arm_, turret, load_, gravity_B_, options.kinematics), options);
  }
  std::vector<ToolGoal> goal_of;
  std::vector<VectorXd> from;
  for (const std::size_t k : which) goal_of.push_back(goals[k]), from.push_back(starts[k]);
  std::vector<Branch> led = leadToGoals(*problem_, goal_of, from);
  for (std::size_t n = 0; n < which.size(); ++n) found[which[n]] = std::move(led[n]);
  if (!dependsOnPosture(arm_)) return;
  // If an effect scales a reading, wrapping the reading by a whole turn moves the tip. The goal is then solved again
  // from the wrapped posture.
  std::vector<std::size_t> turned;
  goal_of.clear(), from.clear();
  for (const std::size_t k : which) {
    if (found[k].status != BranchStatus::kConverged) continue;
    VectorXd wrapped = found[k].q;
    wrapIntoLimits(arm_, wrapped);
    if (wrapped != found[k].q) turned.push_back(k), goal_of.push_back(goals[k]), from.push_back(std::move(wrapped));
  }
  led = leadToGoals(*problem_, goal_of, from);
  for (std::size_t n = 0; n < turned.size(); ++n) found[turned[n]] = std::move(led[n]);
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
    parts_->branches.addStarts(goal, starts);
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
      // Except on turret arms, a start gives no branch if the flexible arm does not reach the goal from it.
      if (!known && (parts_->branches.isTurret() || branch.position_error < parts_->options.position_tolerance))
        branches.push_back(std::move(branch));
    }
    summarise(results[g]);
  }
  return results;
}

InverseKinematics InverseSolver::solve(const ToolGoal& goal) { return std::move(solve(std::span(&goal, 1)).front()); }

int mostBranches(const Arm& arm, const InverseKinematicsOptions& options) {
  return isTurretArm(arm) ? kTurretBranches : options.most_branches;
}

Branch refineBranch(const Arm& arm, const ToolGoal& goal, double load, const Vector3d& gravity_B, const VectorXd& start,
                    const InverseKinematicsOptions& options) {
  return InverseSolver(arm, load, gravity_B, options).refine(std::span(&goal, 1), std::span(&start, 1)).front();
}

InverseKinematics solveInverseKinematics(const Arm& arm, const ToolGoal& goal, double load, const Vector3d& gravity_B,
                                         const InverseKinematicsOptions& options) {
  return InverseSolver(arm, load, gravity_B, options).solve(goal);
}

}  // namespace tubeplan::deflection
