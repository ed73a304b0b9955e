// How well the numbers of an arm's file are known where a fit does not find them: by the drawing, or by measurements.
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
  double zero = 7e-4;       ///< rad (0.04 deg), of the zeros of turning joints
  double axis = 3.5e-4;     ///< rad (0.02 deg), of the directions of axes
  double length = 3.81e-4;  ///< m (0.015 in), of distances between axes and of the zeros of slides
  double tip = 5.08e-4;     ///< m (0.020 in), of each coordinate of the tool's tip

  std::vector<std::string> determined;  ///< names of numbers that measurements determined together ...
  Eigen::MatrixXd covariance;           ///< ... and the covariance of their values [internal units]

  /// An arm whose numbers are all exact.
  [[nodiscard]] static ArmUncertainty none() { return {0, 0, 0, 0, 0, 0, {}, {}}; }
};

/// Numbers of an arm that are known together, as normal variables that are zero where the numbers stand in it.
struct UncertainNumbers {
  std::vector<Unknown> unknowns;  ///< n numbers
  Eigen::MatrixXd root;           ///< n x k: the variables are `root` times k independent standard normals
};

/// Returns the numbers whose standard deviation is above zero. Placements that only move the whole arm, those up to
/// the first joint's axis, belong to the base and are left out; of a beam's E and I the latter stands for both.
[[nodiscard]] UncertainNumbers uncertainNumbers(const deflection::Arm& arm, const ArmUncertainty& uncertainty);

}  // namespace tubeplan::calibration
