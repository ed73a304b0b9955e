// Where the base stands, from three or more touched holes (Calkins 1994, section 5.4; more than three as section 6.2
// asks).
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/least_squares.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// A hole that a touch may have been mistaken for.
struct NeighbourHole {
  std::string name;
  Eigen::Vector3d p_WH = Eigen::Vector3d::Zero();  ///< m
};
using NeighbourQuestion = std::function<std::vector<NeighbourHole>(const Measurement& touch)>;

struct BaseCalibrationOptions {
  double model_sigma =
      7.62e-4;  ///< m per coordinate (0.030 in, the thesis's mean touch error): what the model may be off
  double collinear_ratio = 0.05;        ///< least height of the touches' triangle against its longest side
  double mistaken_hole_p_value = 1e-4;  ///< below it, touches are searched for a mistaken hole; 0: never
  NeighbourQuestion neighbours;         ///< of the hole that a touch names, for telling a mistaken one
  std::optional<double> model_error;    ///< m, as in FitOptions
  LeastSquaresMethod method = LeastSquaresMethod::kHybrid;
};

enum class CalibrationStatus { kNotRun, kDone, kRefused, kNotConverged };

struct TouchResidual {
  std::string id, hole;
  Eigen::Vector3d residual_W = Eigen::Vector3d::Zero();  ///< tip minus hole [m]
  Eigen::Vector3d sigma_W = Eigen::Vector3d::Zero();     ///< of the reading itself
};

/// Distance between two touched holes: by the arm, and on the sheet. Independent of where the base stands.
struct DistanceCheck {
  std::string from, to;
  double by_arm = 0, on_sheet = 0, sigma = 0;  ///< m
};

struct BaseCalibration {
  CalibrationStatus status = CalibrationStatus::kNotRun;
  std::string reason;                 ///< why refused
  std::vector<std::string> suspects;  ///< "touch T2 named R10C20 fits R10C21"
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  Eigen::Matrix<double, 6, 6> covariance =
      Eigen::Matrix<double, 6, 6>::Constant(std::numeric_limits<double>::quiet_NaN());
  int odd_touch = -1;  ///< the one touch, of four or more that do not fit, without which the others do
  double rms_of_others = std::numeric_limits<double>::quiet_NaN();  ///< m, then
  std::vector<TouchResidual> residuals;
  std::vector<DistanceCheck> distances;
  double rms = std::numeric_limits<double>::quiet_NaN();   ///< of the residuals' lengths [m]
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< against the readings' own noise
  double p_value = std::numeric_limits<double>::quiet_NaN();
  double model_error = 0;  ///< m, standard deviation of each coordinate beyond the noise, as the covariance has it
  int degrees_of_freedom = 0;
  int iterations = 0;
  /// From where the search started, which is where the base should stand: shift [m], then rotation vector [rad], world
  /// axes.
  BaseStep from_start = BaseStep::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// Whether chi-square refuses the fit at the touches' stated noise (p < 0.01): what the arm does is not what its model
/// says, or a touch is not where it is said to be.
[[nodiscard]] bool isFitRefused(const BaseCalibration& calibration);

/// The base pose by fitUnknowns() with nothing else free, from any start: touches of known places, of one set-up, each
/// with its sigma. The covariance is the fit's: where chi-square refuses the stated noise (p < 0.01) it has the model's
/// own error.
[[nodiscard]] BaseCalibration calibrateBase(const deflection::Arm& arm, const std::vector<Measurement>& touches,
                                            const Eigen::Isometry3d& X_WB_start,
                                            const BaseCalibrationOptions& options = {});

/// Why these touches cannot place a base (fewer than three holes, one hole twice under the same load, near a line), or
/// empty.
std::string findTouchProblem(const std::vector<Measurement>& touches, const BaseCalibrationOptions& options = {});

}  // namespace tubeplan::calibration
