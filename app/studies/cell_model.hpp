// What studies know of a cell: an arm on its base, with the tube sheet, the calibration tool and the scene around it
// where it has them.
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

/// How far the base may stand from where the cell has it before it is calibrated: standard deviation of each coordinate
/// and about each axis.
struct BasePrior {
  double shift = 0.0127;  ///< m (0.5 in)
  double turn = 0.0087;   ///< rad (0.5 deg)
};

/// What the arm does at a posture beyond its model, as somebody found it: standard deviation of each coordinate of the
/// tip.
struct ModelError {
  double sigma = 0;            ///< m
  int degrees_of_freedom = 0;  ///< by which it was found; 0: taken as known
  std::string from;            ///< how it was found: "identify", kByTouches; empty: somebody wrote it
};

/// ModelError::from of an error estimated from the touches of a calibration.
inline constexpr const char* kByTouches = "touches";

/// Touches that placed the base, and the arm as its file has it: beside that base the arm's numbers are as the touches
/// have them.
struct PlacedByTouches {
  std::vector<calibration::Measurement> touches;
  deflection::Arm filed_arm;
};

/// Internal units throughout.
struct CellModel {
  deflection::Arm arm;  ///< with the tool axis that the cell states, where the arm file does not
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< world = tube-sheet frame
  bool base_known = false;
  bool tool_axis_stated = false;            ///< by the arm file or by the scene; else the arm has the default
  std::optional<Matrix6d> base_covariance;  ///< of shift [m] and small turn [rad] along and about the world's x, y, z
  BasePrior base_prior;
  std::optional<PlacedByTouches> placed_by;  ///< none: nobody touched, or somebody wrote the base
  calibration::ArmUncertainty uncertainty;   ///< of the arm's numbers where they are not fitted
  std::optional<ModelError> model_error;
  std::optional<tubesheets::Sheet> sheet;
  std::optional<tubesheets::SteppedTool> tool;
  std::optional<Eigen::VectorXd> park;  ///< joint readings to rest in [rad, m]
  planner::Scene scene;                 ///< links only where the file has neither scene nor shapes
  std::vector<std::string> identify;    ///< dotted names, or `geometry`
  calibration::Priors priors;           ///< of what a fit frees

  /// The model's own error where it is known by more than the touches of a base.
  [[nodiscard]] std::optional<ModelError> knownModelError() const {
    return model_error && model_error->from != kByTouches ? model_error : std::nullopt;
  }

  /// The arm as its file has it.
  [[nodiscard]] const deflection::Arm& filedArm() const { return placed_by ? placed_by->filed_arm : arm; }
};

}  // namespace tubeplan::app
