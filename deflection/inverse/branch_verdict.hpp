// Status and reason of a branch found from a start posture, and of all branches together. Internal to the inverse
// kinematics.
#pragma once

#include <cmath>

#include "deflection/inverse/inverse_kinematics.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

/// Returns the absolute difference between two readings of a revolute joint [rad], modulo whole turns.
inline double angleDifference(double a, double b) {
  const double off = std::abs(a - b);
  return off <= kFullTurn / 2 ? off : std::abs(std::remainder(off, kFullTurn));
}

/// Shifts revolute readings by whole turns into their joint limits, up to the first joint for which this is impossible.
/// Returns the name of that joint; empty if all readings are within their limits.
std::string wrapIntoLimits(const Arm& arm, Eigen::VectorXd& q);

/// Sets the status and reason of a branch from its residuals.
void judge(const Arm& arm, const InverseKinematicsOptions& options, Branch& branch);

/// Returns true if two postures are nearly equal modulo whole turns.
[[nodiscard]] bool isSameBranch(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// Sorts usable branches first, and copies the status and reason of the best branch to the result.
void summarise(InverseKinematics& result);

}  // namespace tubeplan::deflection
