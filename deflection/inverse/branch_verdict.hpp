// Status and reason of a branch found from a start, and of all branches together. Internal to the inverse.
#pragma once

#include <cmath>

#include "deflection/inverse/inverse_kinematics.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

/// Returns the difference between two readings of a revolute joint [rad], less whole turns.
inline double angleApart(double a, double b) {
  const double off = std::abs(a - b);
  return off <= kFullTurn / 2 ? off : std::abs(std::remainder(off, kFullTurn));
}

/// Brings each revolute reading into its limits by whole turns where possible. Returns the name of the joint that
/// cannot be.
std::string wrapIntoLimits(const Arm& arm, Eigen::VectorXd& q);

/// Sets status and reason of a branch from its residuals.
void judge(const Arm& arm, const InverseKinematicsOptions& options, Branch& branch);

/// Returns true if two postures are equal but for whole turns.
[[nodiscard]] bool isSameBranch(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// Puts usable branches first and sets the overall status and reason to those of the best.
void summarise(InverseKinematics& result);

}  // namespace tubeplan::deflection
