// The cell as studies use it: an arm on its base, with the tube sheet, the calibration tool and the scene around it if
// it has them.
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

/// Uncertainty of the base's place before its calibration: standard deviation of each coordinate and about each axis.
struct BasePrior {
  double shift = 0.0127;  ///< [m] (0.5 in)
  double turn = 0.0087;   ///< [rad] (0.5 deg)
};

/// Stated error of the arm at a posture beyond its model: standard deviation of each coordinate of the tip.
struct ModelError {
  double sigma = 0;            ///< [m]
  int degrees_of_freedom = 0;  ///< degrees of freedom of its estimate; 0: taken as known
  std::string from;            ///< source of the figure: "identify", kByTouches; empty: written by hand
};

/// ModelError::from of an error estimated from the touches of a calibration.
inline constexpr const char* kByTouches = "touches";

/// Touches that placed the base, and the arm as in its file; with that base, the arm's numbers are those fitted to the
/// touches.
struct PlacedByTouches {
  std::vector<calibration::Measurement> touches;
  deflection::Arm filed_arm;
};

/// A cell in internal units.
struct CellModel {
  deflection::Arm arm;  ///< the arm, with the tool axis that the cell states, if the arm file does not
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< world = tube-sheet frame
  bool base_known = false;
  bool tool_axis_stated = false;  ///< true: stated by the arm file or the scene; false: the default
  /// Covariance of shift [m] and small rotation [rad] along and about the world's x, y, z.
  std::optional<Matrix6d> base_covariance;
  BasePrior base_prior;
  /// Touches that placed the base; nothing if there are none, or if the base was written by hand.
  std::optional<PlacedByTouches> placed_by;
  calibration::ArmUncertainty uncertainty;  ///< uncertainty of the arm's numbers that are not fitted
  std::optional<ModelError> model_error;
  std::optional<tubesheets::Sheet> sheet;
  std::optional<tubesheets::SteppedTool> tool;
  std::optional<Eigen::VectorXd> park;  ///< joint readings of the rest position [rad, m]
  planner::Scene scene;                 ///< the scene, with links only if the file has neither scene nor shapes
  std::vector<std::string> identify;    ///< dotted names, or `geometry`
  calibration::Priors priors;           ///< priors of the numbers that a fit frees

  /// Returns the model's own error, unless it is known from the touches of a base alone.
  [[nodiscard]] std::optional<ModelError> knownModelError() const {
    return model_error && model_error->from != kByTouches ? model_error : std::nullopt;
  }

  /// Returns the arm as in its file.
  [[nodiscard]] const deflection::Arm& filedArm() const { return placed_by ? placed_by->filed_arm : arm; }
};

}  // namespace tubeplan::app
