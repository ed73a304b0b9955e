// The robot cell as the studies use it: an arm on its base and, if the cell has them, a tube sheet, a calibration tool
// and a scene.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/arm_uncertainty.hpp"
#include "calibration/placed_arm.hpp"
#include "deflection/arm.hpp"
#include "planner/scene/scene.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/stepped_tool.hpp"

namespace tubeplan::app {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Uncertainty of the base pose before calibration: standard deviation of each coordinate of the position and of the
/// rotation about each axis.
struct BasePrior {
  double shift = 0.0127;  ///< standard deviation of the position per coordinate [m] (0.5 in)
  double turn = 0.0087;   ///< standard deviation of the rotation per axis [rad] (0.5 deg)
};

/// Tip error that the arm's model does not predict, as stated in the cell. Errors of different postures are
/// independent.
struct ModelError {
  double sigma = 0;            ///< standard deviation per coordinate of the tip [m]
  int degrees_of_freedom = 0;  ///< degrees of freedom with which `sigma` was estimated; 0 if `sigma` is exact
  std::string from;            ///< source of `sigma`: "identify" or kByTouches; empty if it was written by hand
};

/// Value of ModelError::from for an error estimated from the touches of a base calibration.
inline constexpr const char* kByTouches = "touches";

/// Touches from which the base was calibrated, and the arm as in its file. CellModel::arm then has the parameters
/// fitted to the touches.
struct PlacedByTouches {
  std::vector<calibration::Measurement> touches;
  deflection::Arm filed_arm;
};

/// A cell in internal units (m, N, rad, s, K).
struct CellModel {
  deflection::Arm arm;  ///< the arm; if its file states no tool axis, it has the cell's tool axis
  /// Base pose in the world, which is the frame of the tube sheet.
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  bool base_known = false;
  /// True if the arm file or the scene states the tool axis; false if the axis is the default.
  bool tool_axis_stated = false;
  /// Covariance of the base's translation [m] along and small rotation [rad] about the world's x, y, z axes.
  std::optional<Matrix6d> base_covariance;
  BasePrior base_prior;
  /// Touches from which the base was calibrated; std::nullopt if it was not calibrated or was written by hand.
  std::optional<PlacedByTouches> placed_by;
  calibration::ArmUncertainty uncertainty;  ///< uncertainty of the arm parameters that are not fitted
  std::optional<ModelError> model_error;
  std::optional<tubesheets::Sheet> sheet;
  std::optional<tubesheets::SteppedTool> tool;
  std::optional<Eigen::VectorXd> park;  ///< joint values of the parking position [rad, m]
  /// The scene; contains only the arm's links if the file has neither scene nor shapes.
  planner::Scene scene;
  std::vector<std::string> identify;  ///< dotted names of the parameters to fit, or `geometry`
  calibration::Priors priors;         ///< priors of the parameters to fit

  /// Returns the stated model error; std::nullopt if there is none or if it was estimated from the touches of a base
  /// calibration.
  [[nodiscard]] std::optional<ModelError> knownModelError() const {
    return model_error && model_error->from != kByTouches ? model_error : std::nullopt;
  }

  /// Returns the arm as in its file, without the parameters fitted to touches.
  [[nodiscard]] const deflection::Arm& filedArm() const { return placed_by ? placed_by->filed_arm : arm; }
};

}  // namespace tubeplan::app
