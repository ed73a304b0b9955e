#include "deflection/branch_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tubeplan::deflection {

namespace {

using Eigen::VectorXd;
constexpr double kTurn = 2 * std::numbers::pi;

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

}  // namespace

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

}  // namespace tubeplan::deflection
