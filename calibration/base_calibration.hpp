// Where the base stands, from three or more touched holes (Calkins 1994, section 5.4; more than three as section 6.2
// asks).
#pragma once

#include <string>
#include <vector>

#include "calibration/base_residual.hpp"
#include "calibration/least_squares.hpp"

namespace tubeplan::calibration {

struct BaseCalibrationOptions {
  double model_sigma =
      7.62e-4;  ///< m per coordinate (0.030 in, the thesis's mean touch error): what the model may be off
  double collinear_ratio = 0.05;        ///< least height of the touches' triangle against its longest side
  double mistaken_hole_p_value = 1e-4;  ///< below it, touches are searched for a mistaken hole
  int alignments = 12;                  ///< closed-form alignments before the solver; each corrects gravity's direction
  LeastSquaresMethod method = LeastSquaresMethod::kInTurn;
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
  std::vector<TouchResidual> residuals;
  std::vector<DistanceCheck> distances;
  double rms = std::numeric_limits<double>::quiet_NaN();   ///< of the residuals' lengths [m]
  double chi2 = std::numeric_limits<double>::quiet_NaN();  ///< against the readings' own noise
  double p_value = std::numeric_limits<double>::quiet_NaN();
  int degrees_of_freedom = 0;
  int iterations = 0;
  /// From where the search started, which is where the base should stand: shift [m], then rotation vector [rad], world
  /// axes.
  BaseStep from_start = BaseStep::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// Whether chi-square refuses the fit at the touches' stated noise (p < 0.01): what the arm does is not what its model
/// says, or a touch is not where it is said to be.
[[nodiscard]] bool isFitRefused(const BaseCalibration& calibration);

/// Least-squares base pose on the flexible model, each touch weighted by its centring and encoder noise, starting from
/// any pose. The covariance is that of the readings' noise; a model that is off shows in chi2, not in it.
[[nodiscard]] BaseCalibration calibrateBase(const deflection::Arm& arm, const std::vector<Touch>& touches,
                                            const Eigen::Isometry3d& X_WB_start,
                                            const BaseCalibrationOptions& options = {});

/// The covariance to work with: that of the readings' noise, widened by chi-square per degree of freedom where the
/// model is off.
[[nodiscard]] Eigen::Matrix<double, 6, 6> widenedCovariance(const BaseCalibration& calibration);

/// Why these touches cannot place a base (fewer than three holes, one hole twice under the same load, near a line), or
/// empty.
std::string findTouchProblem(const std::vector<Touch>& touches, const BaseCalibrationOptions& options = {});

}  // namespace tubeplan::calibration
