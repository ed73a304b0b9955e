// The residual turned into joint angles: how wrong every joint's reading would have to be, if nothing else were.
//
// With J the tip's derivative by the joints and S the encoders' covariance, dq = -S J^T (J S J^T)^+ e is the least
// correction of the readings, in encoder sigmas, that takes the predicted tip to the measured one.
#pragma once

#include <limits>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// rad (m on a slide); joints in the order of the arm's active rows.
struct JointEquivalents {
  bool ok = false;               ///< whether the model could be evaluated
  Eigen::MatrixXd corrections;   ///< joints x readings, to be added to what was read
  Eigen::VectorXd mean, spread;  ///< of each joint's corrections; the spread is their standard deviation
  Eigen::VectorXd sigma;         ///< stated for each encoder; 0 where none is
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< by the encoders' noise alone; NaN where none is stated
  int degrees_of_freedom = 0;
  double p_value = std::numeric_limits<double>::quiet_NaN();
};

/// `error` [m]: predicted less measured, rows of the readings one after another. Encoders that state no sigma are exact
/// beside others that do; where none does, all joints count alike.
[[nodiscard]] JointEquivalents equivalentJoints(const PlacedArm& placed, const std::vector<Measurement>& readings,
                                                const Eigen::VectorXd& error);

}  // namespace tubeplan::calibration
