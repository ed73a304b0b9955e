// The residual converted to joint angles: the error that each joint reading would have if nothing else were wrong.
//
// With J the tip's Jacobian with respect to the joints, S the encoders' covariance and e the residual, dq = -S J^T (J S
// J^T)^+ e is the smallest correction of the joint readings, in encoder sigmas, that moves the predicted tip to the
// measured tip.
#pragma once

#include <limits>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Corrections of joint readings [rad, m for a prismatic joint], with joints in the order of the arm's active rows.
struct JointEquivalents {
  bool ok = false;               ///< false if the model could not be evaluated
  Eigen::MatrixXd corrections;   ///< corrections to be added to the joint readings, joints x measurements
  Eigen::VectorXd mean, spread;  ///< mean and standard deviation of each joint's corrections over the measurements
  Eigen::VectorXd sigma;         ///< stated standard deviation of each encoder; 0 if not stated
  /// Chi-square of the residual if encoder noise were its only cause; NaN if no encoder noise is stated.
  double chi2 = std::numeric_limits<double>::quiet_NaN();
  int degrees_of_freedom = 0;
  double p_value = std::numeric_limits<double>::quiet_NaN();
};

/// Computes the corrections. `error` is predicted minus measured [m], with the rows of all measurements stacked. If
/// only some encoders have a stated sigma, the others are treated as exact; if none has, all joints have equal weight.
[[nodiscard]] JointEquivalents equivalentJoints(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                                                const Eigen::VectorXd& error);

}  // namespace tubeplan::calibration
