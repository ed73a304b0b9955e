// The residual converted into joint angles: the error of every joint's reading if there were no other cause.
//
// With J the tip's derivative by the joints and S the encoders' covariance, dq = -S J^T (J S J^T)^+ e is the least
// correction of the readings, in encoder sigmas, that takes the predicted tip to the measured one.
#pragma once

#include <limits>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Corrections of joint readings [rad, m on a slide], with joints in the order of the arm's active rows.
struct JointEquivalents {
  bool ok = false;               ///< false: the model could not be evaluated
  Eigen::MatrixXd corrections;   ///< joints x readings, to be added to the readings
  Eigen::VectorXd mean, spread;  ///< mean and standard deviation of each joint's corrections
  Eigen::VectorXd sigma;         ///< stated sigma of each encoder; 0 if none is stated
  /// Chi-square by the encoders' noise alone; NaN if none is stated.
  double chi2 = std::numeric_limits<double>::quiet_NaN();
  int degrees_of_freedom = 0;
  double p_value = std::numeric_limits<double>::quiet_NaN();
};

/// Computes the corrections. `error` [m]: predicted minus measured, rows of the readings one after another. Encoders
/// without a stated sigma count as exact beside others that have one; if none has, all joints count alike.
[[nodiscard]] JointEquivalents equivalentJoints(const PlacedArm& placed, const std::vector<Measurement>& readings,
                                                const Eigen::VectorXd& error);

}  // namespace tubeplan::calibration
