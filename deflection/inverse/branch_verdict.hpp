// What is said of a branch that a start was led to, and of all branches together. Internal to the inverse.
#pragma once

#include <cmath>

#include "deflection/inverse/inverse_kinematics.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

/// Between two readings of a joint that turns [rad], whole turns aside.
inline double angleApart(double a, double b) {
  const double off = std::abs(a - b);
  return off <= kFullTurn / 2 ? off : std::abs(std::remainder(off, kFullTurn));
}

/// Brings each revolute reading into its limits by whole turns where that is possible, and names the one that is not.
std::string wrapIntoLimits(const Arm& arm, Eigen::VectorXd& q);

/// Status and reason of a branch as it was found.
void judge(const Arm& arm, const InverseKinematicsOptions& options, Branch& branch);

/// Whether two postures are the same but for whole turns.
[[nodiscard]] bool isSameBranch(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// Puts usable branches first and says of the whole what the best of them is.
void summarise(InverseKinematics& result);

}  // namespace tubeplan::deflection
