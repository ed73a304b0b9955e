// Uncertainty of an arm's numbers that a fit does not find: from the drawing, or from measurements.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Standard deviations of an arm's numbers about their values in its file. The defaults are those of an arm that is
/// built to a drawing and checked by hand.
struct ArmUncertainty {
  double stiffness = 0.1;   ///< share of each stiffness, and of the size of each effect
  double weight = 0.02;     ///< share of each weight
  double zero = 7e-4;       ///< sigma of the zeros of revolute joints [rad] (0.04 deg)
  double axis = 3.5e-4;     ///< sigma of the directions of axes [rad] (0.02 deg)
  double length = 3.81e-4;  ///< sigma of distances between axes and of the zeros of slides [m] (0.015 in)
  double tip = 5.08e-4;     ///< sigma of each coordinate of the tool's tip [m] (0.020 in)

  std::vector<std::string> determined;  ///< names of numbers that measurements determined together
  Eigen::MatrixXd covariance;           ///< covariance of the values of `determined` [internal units]

  /// Returns the uncertainty of an arm with exact numbers.
  [[nodiscard]] static ArmUncertainty none() { return {0, 0, 0, 0, 0, 0, {}, {}}; }
};

/// Numbers of an arm with a joint normal distribution, as variables that are zero at the arm's values.
struct UncertainNumbers {
  std::vector<Unknown> unknowns;  ///< n numbers
  Eigen::MatrixXd root;           ///< n x k: the variables are `root` times k independent standard normals
};

/// Returns the numbers with a standard deviation above zero. Placements that only move the whole arm, those up to the
/// first joint's axis, belong to the base and are left out. Of a beam's E and I only I is included, for both.
[[nodiscard]] UncertainNumbers uncertainNumbers(const deflection::Arm& arm, const ArmUncertainty& uncertainty);

}  // namespace tubeplan::calibration
