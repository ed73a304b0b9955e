#include "deflection/inverse/goal_newton.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "deflection/inverse/free_motion.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::Dynamic, Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
/// Smallest derivative of the position, divided by the reach, that is distinguished from zero.
constexpr double kPlaceFloor = 1e-4;
/// Weight of the position residual (as a fraction of the reach), relative to the tilt [rad], in the merit of a posture.
constexpr double kPlaceWeight = 10;
constexpr double kLimitWeight = 2;  ///< weight of the excess over joint limits [rad or fraction of the reach]
/// The iteration may end once the step that brings joints into their limits is shorter than this [rad or fraction of
/// the reach].
constexpr double kIntoLimits = 1e-3;
constexpr double kLongestScaledStep = 0.5;  ///< longest step of any joint [rad or fraction of the reach]
constexpr double kLeastShare = 0.1;         ///< smallest fraction of a step that is tried
constexpr int kMostStrikes = 4;             ///< number of steps without improvement before a start is abandoned
constexpr std::size_t kSideBySide = 32;

/// Returns the smallest singular value of the derivatives of the position and, if `with_lean` (for turret arms), of the
/// pitch.
double smallestSingularValue(const GoalResidual& r, bool with_lean) {
  const Index rows = r.by_off.rows() + (with_lean ? r.by_lean.rows() : 0);
  Eigen::Matrix<double, Dynamic, Dynamic, 0, 6, Dynamic> held(rows, r.by_off.cols());
  held.topRows(r.by_off.rows()) = r.by_off;
  if (with_lean) held.bottomRows(r.by_lean.rows()) = r.by_lean;
  Eigen::Matrix<double, Dynamic, Dynamic, 0, 6, 6> square(rows, rows);
  square.noalias() = held.lazyProduct(held.transpose());
  return std::sqrt(std::max(
      0., Eigen::SelfAdjointEigenSolver<decltype(square)>(square, Eigen::EigenvaluesOnly).eigenvalues().minCoeff()));
}

struct GoalStep {
  VectorXd joints;         ///< step of the joints [rad or fraction of the reach]
  double lean = 0;         ///< predicted reduction of the tilt [rad]
  double into_limits = 0;  ///< length of the part that moves joints into their limits
};

/// Adds a motion of the joints back into their limits, without changing the position or the tilt.
void addWayIntoLimits(const GoalProblem& problem, const VectorXd& q, FreeMotion& free, GoalStep& step) {
  std::vector<Index> past;
  for (Index k = 0; k < q.size(); ++k)
    if (problem.pastLimit(k, q[k]) != 0) past.push_back(k);
  if (past.empty()) return;
  const auto count = static_cast<Index>(past.size());
  MatrixXd which = MatrixXd::Zero(count, q.size());
  VectorXd wanted(count);
  for (Index row = 0; row < count; ++row) {
    const Index k = past[static_cast<std::size_t>(row)];
    which(row, k) = 1;
    wanted[row] = -problem.pastLimit(k, q[k]) - step.joints[k];
  }
  const VectorXd back = free.take<Dynamic>(which, wanted, 0.1);
  step.joints += back;
  step.into_limits = back.norm();
}

GoalStep stepFrom(const GoalProblem& problem, const GoalResidual& r, const VectorXd& q) {
  GoalStep step;
  FreeMotion free(q.size());
  step.joints = free.take<3>(r.by_off, -r.off, kPlaceFloor);
  const GoalSides lean = -r.lean - r.by_lean.lazyProduct(step.joints);
  const VectorXd upright =
      free.take<3>(r.by_lean, lean, problem.isTurret() ? kPlaceFloor : problem.options().singular_floor);
  step.joints += upright;
  step.lean = r.by_lean.lazyProduct(upright).norm();
  addWayIntoLimits(problem, q, free, step);
  return step;
}

bool isMet(const GoalProblem& problem, const GoalResidual& r, const GoalStep& step) {
  const InverseKinematicsOptions& options = problem.options();
  const double lean = problem.isTurret() ? std::abs(r.lean[0]) : step.lean;
  return r.position_error < options.position_tolerance && lean < options.pitch_tolerance &&
         step.into_limits < kIntoLimits && (!problem.isTurret() || r.tilt < std::numbers::pi / 2);
}

/// Returns the merit of a posture, which the iteration reduces: a weighted sum of position residual, tilt and excess
/// over joint limits.
double meritOf(const GoalProblem& problem, const GoalResidual& r, const VectorXd& q) {
  double past = 0;
  for (Index k = 0; k < q.size(); ++k) past += std::pow(problem.pastLimit(k, q[k]), 2);
  return kPlaceWeight * r.off.norm() + r.lean.norm() + kLimitWeight * std::sqrt(past);
}

/// Iteration from one start to its goal. The caller evaluates the tip at each requested posture.
class Lead {
 public:
  void begin(std::size_t which, const VectorXd& start) {
    which_ = which;
    next_q_ = start;
    strikes_ = iterations_ = 0;
    status_ = BranchStatus::kNotRun;
    is_first_ = true;
  }

  [[nodiscard]] std::size_t which() const { return which_; }
  /// Returns the joint readings at which the caller must evaluate the tip next.
  [[nodiscard]] const VectorXd& requestedReadings() const { return next_q_; }

  /// Continues the iteration with the tip evaluated at requestedReadings(); returns false once the iteration has ended.
  bool arrive(const GoalProblem& problem, const ToolGoal& goal, TipMotion& tip) {
    problem.evaluate(goal, tip, next_residual_);
    if (is_first_) {
      is_first_ = false;
      take();
      return stepOn(problem);
    }
    if (meritOf(problem, next_residual_, next_q_) < merit_) {
      take();
      ++iterations_;
      return stepOn(problem);
    }
    share_ /= 2;
    if (share_ > kLeastShare) {
      next_q_ = q_ + share_ * full_step_;
      return true;
    }
    // If even the shortest step does not reduce the merit, take it nevertheless, up to kMostStrikes times.
    if (next_residual_.isFinite()) take();
    if (++strikes_ == kMostStrikes) return false;
    ++iterations_;
    return stepOn(problem);
  }

  [[nodiscard]] Branch branch(const GoalProblem& problem) const {
    Branch branch;
    branch.status = status_;
    branch.iterations = iterations_;
    branch.q = q_;
    branch.position_error = current_residual_.position_error;
    branch.tilt = current_residual_.tilt;
    if (current_residual_.isFinite())
      branch.smallest_singular_value = smallestSingularValue(current_residual_, problem.isTurret());
    return branch;
  }

 private:
  void take() {
    q_ = next_q_;
    std::swap(current_residual_, next_residual_);
  }

  bool stepOn(const GoalProblem& problem) {
    if (iterations_ >= problem.options().max_iterations || !current_residual_.isFinite()) return false;
    const GoalStep step = stepFrom(problem, current_residual_, q_);
    if (isMet(problem, current_residual_, step)) {
      status_ = BranchStatus::kConverged;
      return false;
    }
    merit_ = meritOf(problem, current_residual_, q_);
    const double longest = step.joints.cwiseAbs().maxCoeff();
    full_step_ =
        problem.scale().cwiseProduct(step.joints) * (longest > kLongestScaledStep ? kLongestScaledStep / longest : 1);
    share_ = 1;
    next_q_ = q_ + full_step_;
    return true;
  }

  std::size_t which_ = 0;
  GoalResidual current_residual_, next_residual_;
  VectorXd q_, next_q_, full_step_;  ///< readings [rad, m]; fractions of the full step are tried
  double merit_ = 0, share_ = 1;
  int strikes_ = 0, iterations_ = 0;
  bool is_first_ = true;
  BranchStatus status_ = BranchStatus::kNotRun;
};

}  // namespace

std::vector<Branch> leadToGoals(GoalProblem& problem, std::span<const ToolGoal> goals,
                                std::span<const VectorXd> starts) {
  assert(goals.size() == starts.size());
  std::vector<Branch> found(starts.size());
  std::vector<Lead> leads(std::min(kSideBySide, starts.size()));
  std::vector<TipMotion> tips(leads.size());
  MatrixXd q(problem.scale().size(), static_cast<Index>(leads.size()));
  std::size_t next = 0, active = 0;
  while (true) {
    for (; active < leads.size() && next < starts.size(); ++next) leads[active++].begin(next, starts[next]);
    if (active == 0) return found;
    for (std::size_t k = 0; k < active; ++k) q.col(static_cast<Index>(k)) = leads[k].requestedReadings();
    problem.place(q.leftCols(static_cast<Index>(active)), std::span(tips).first(active));
    for (std::size_t k = active; k-- > 0;) {
      Lead& lead = leads[k];
      if (lead.arrive(problem, goals[lead.which()], tips[k])) continue;
      found[lead.which()] = lead.branch(problem);
      std::swap(lead, leads[--active]);
    }
  }
}

}  // namespace tubeplan::deflection
