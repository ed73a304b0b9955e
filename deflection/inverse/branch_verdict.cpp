#include "deflection/inverse/branch_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::VectorXd;
constexpr const char* kStretched = "the arm is stretched or folded: smallest singular value below the floor";
constexpr const char* kNextToSingular =
    "reached only next to a singular posture, stretched, folded or over an axis: smallest singular value below the "
    "floor";

std::string degrees(double angle) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << angle * 360 / kFullTurn;
  return text.str();
}

/// Returns the rank of a branch, where lower is better: 0 for usable branches, 1 and 2 for other branches that reach
/// the goal position within the joint limits.
int severity(const Branch& branch) {
  if (branch.status == BranchStatus::kSingular && branch.reason == kNextToSingular) return 1;
  switch (branch.status) {
    case BranchStatus::kConverged:
      return 0;
    case BranchStatus::kTiltTooLarge:
      return 2;
    case BranchStatus::kPastJointLimit:
      return 3;
    case BranchStatus::kSingular:
      return 4;
    case BranchStatus::kNotConverged:
      return 5;
    default:
      return 6;
  }
}

}  // namespace

std::string wrapIntoLimits(const Arm& arm, VectorXd& q) {
  Eigen::Index k = 0;
  for (const auto& row : arm.rows) {
    const auto& joint = row.joint;
    if (joint.type == JointType::kPassive) continue;
    if (joint.type == JointType::kRevolute) {
      q[k] = std::remainder(q[k], kFullTurn);
      if (q[k] < joint.lower && q[k] + kFullTurn <= joint.upper) q[k] += kFullTurn;
      if (q[k] > joint.upper && q[k] - kFullTurn >= joint.lower) q[k] -= kFullTurn;
    }
    if (q[k] < joint.lower || q[k] > joint.upper) return joint.name;
    ++k;
  }
  return {};
}

void judge(const Arm& arm, const InverseKinematicsOptions& options, Branch& branch) {
  const bool flat = branch.smallest_singular_value < options.singular_floor;
  if (branch.status != BranchStatus::kConverged) {
    branch.status = flat ? BranchStatus::kSingular : BranchStatus::kNotConverged;
    branch.reason = flat ? kStretched : "no posture was found that reaches the place";
    return;
  }
  const std::string joint = wrapIntoLimits(arm, branch.q);
  if (!joint.empty()) {
    branch.status = BranchStatus::kPastJointLimit;
    branch.reason = "past the limit of joint " + joint;
  } else if (flat) {
    branch.status = BranchStatus::kSingular;
    branch.reason = kNextToSingular;
  } else if (branch.tilt > options.max_tilt) {
    branch.status = BranchStatus::kTiltTooLarge;
    branch.reason = "the tool leans by " + degrees(branch.tilt) + " deg at least, more than the " +
                    degrees(options.max_tilt) + " deg allowed";
  }
}

bool isSameBranch(const VectorXd& a, const VectorXd& b) {
  for (Eigen::Index k = 0; k < a.size(); ++k)
    if (!(angleDifference(a[k], b[k]) < 1e-4)) return false;
  return true;
}

void summarise(InverseKinematics& result) {
  std::stable_sort(result.branches.begin(), result.branches.end(),
                   [](const Branch& a, const Branch& b) { return severity(a) < severity(b); });
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
    case BranchStatus::kTiltTooLarge:
      return "tilt-too-large";
  }
  return "";
}

}  // namespace tubeplan::deflection
