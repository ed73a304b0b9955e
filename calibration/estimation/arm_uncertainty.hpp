// Uncertainty of the arm's parameters that a fit does not determine, as known from the drawing or from earlier
// measurements.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Standard deviations of an arm's parameters about the values in the arm's file. The defaults are for an arm that is
/// built to a drawing and checked by hand.
struct ArmUncertainty {
  double stiffness = 0.1;  ///< relative standard deviation of each stiffness and of each effect's magnitude
  double weight = 0.02;    ///< relative standard deviation of each weight
  double zero = 7e-4;      ///< standard deviation of the zeros of revolute joints [rad] (0.04 deg)
  double axis = 3.5e-4;    ///< standard deviation of the angles between axes [rad] (0.02 deg)
  /// Standard deviation of distances between axes and of the zeros of prismatic joints [m] (0.015 in).
  double length = 3.81e-4;
  double tip = 5.08e-4;  ///< standard deviation of each coordinate of the tool's tip [m] (0.020 in)

  std::vector<std::string> determined;  ///< names of parameters that measurements determined jointly
  Eigen::MatrixXd covariance;           ///< covariance of the parameters `determined` [internal units]

  /// Returns the uncertainty of an arm whose parameters are known exactly: zero.
  [[nodiscard]] static ArmUncertainty none() { return {0, 0, 0, 0, 0, 0, {}, {}}; }
};

/// Uncertain parameters of an arm with a joint normal distribution, as variables that are zero at the arm's own values.
struct UncertainNumbers {
  std::vector<Unknown> unknowns;  ///< n uncertain parameters
  Eigen::MatrixXd root;  ///< n x k matrix: the variables are `root` times k independent standard normal variables
};

/// Returns the arm's parameters whose standard deviation is above zero. Excludes parameters that place the rows up to
/// the first joint's axis: they only move the whole arm, as the base does. Of a beam's E and I, only I is included,
/// because measurements depend on their product.
[[nodiscard]] UncertainNumbers uncertainNumbers(const deflection::Arm& arm, const ArmUncertainty& uncertainty);

}  // namespace tubeplan::calibration
