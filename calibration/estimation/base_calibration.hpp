// Calibration of the base pose from three or more touched holes (Calkins 1994, section 5.4; more than three as section
// 6.2 suggests), which also updates the arm's uncertain parameters.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/touch_fit.hpp"

namespace tubeplan::calibration {

/// A hole near a touched one, which the operator may have touched by mistake.
struct NeighbourHole {
  std::string name;
  Eigen::Vector3d p_WH = Eigen::Vector3d::Zero();  ///< centre of the hole in the world frame [m]
};
using NeighbourQuestion = std::function<std::vector<NeighbourHole>(const Measurement& touch)>;

struct BaseCalibrationOptions {
  ArmUncertainty arm;  ///< uncertainty of the arm's parameters, which are fitted together with the base
  /// Usual model error per coordinate [m] (0.030 in, the mean touch error in Calkins 1994).
  double model_sigma = 7.62e-4;
  /// Smallest accepted spread of the holes perpendicular to their best-fit line, relative to their spread along the
  /// line.
  double collinear_ratio = 0.05;
  /// P-value of the fit below which mistaken holes are searched for; 0 disables the search.
  double mistaken_hole_p_value = 1e-4;
  /// Function that returns the holes around a touched hole, used to search for mistaken holes. If empty, the search is
  /// disabled.
  NeighbourQuestion neighbours;
  double model_error = 0;         ///< model error known beforehand, per coordinate [m]
  bool finds_model_error = true;  ///< true if the model error is increased after a lack of fit, until the touches fit
  /// True if the touch or joint reading that causes a lack of fit is searched for.
  bool finds_suspects = true;
  LeastSquaresMethod method = LeastSquaresMethod::kHybrid;
};

enum class CalibrationStatus { kNotRun, kDone, kRefused, kNotConverged };

struct TouchResidual {
  std::string id, hole;
  /// Tip minus hole, for the fitted base and arm, in world axes [m].
  Eigen::Vector3d residual_W = Eigen::Vector3d::Zero();
  /// Standard deviation of touch and encoder noise, in world axes [m].
  Eigen::Vector3d sigma_W = Eigen::Vector3d::Zero();
};

/// Distance between two touched holes, as predicted by the arm described in the file and as known from the tube sheet.
/// Neither depends on the base.
struct DistanceCheck {
  std::string from, to;
  /// Distance predicted by the arm model, and distance according to the tube sheet [m].
  double by_arm = 0, on_sheet = 0;
  /// Standard deviation of the difference, due to touch noise and the arm's uncertain parameters [m].
  double sigma = 0;
};

/// A parameter of the arm that was fitted together with the base.
struct TouchedNumber {
  std::string name;
  deflection::Quantity quantity = deflection::Quantity::kNone;
  double filed = 0, value = 0;      ///< value in the arm's file, and value after the fit
  double prior = 0, posterior = 0;  ///< standard deviation before and after the touches
};

/// A joint reading of one touch, with an error in it that would explain the lack of fit.
struct SuspectMeasurement {
  std::string touch;
  Eigen::Index joint = -1;
  double off = 0;      ///< joint reading minus the value that the other touches require [rad or m]
  double p_value = 0;  ///< p-value of the fit to all touches with this joint reading corrected by `off`
};

struct BaseCalibration : TouchedBase {
  CalibrationStatus status = CalibrationStatus::kNotRun;
  std::string reason;                  ///< reason why no base was found, if the status is not kDone
  std::vector<std::string> suspects;   ///< holes that may be mistaken, such as "touch T2 named R10C20 fits hole R10C21"
  std::vector<TouchedNumber> numbers;  ///< uncertain parameters of the arm, which were fitted with the base
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Constant(kNotKnown);
  /// Index of the only touch whose removal makes the others fit, among at least four touches; otherwise -1.
  int outlier_touch = -1;
  double rms_of_others = kNotKnown;  ///< rms error of the other touches in a fit without the outlier touch [m]
  std::vector<SuspectMeasurement>
      suspect_measurements;  ///< joint readings that may explain a lack of fit, likeliest first
  std::vector<TouchResidual> residuals;
  std::vector<DistanceCheck> distances;
  double rms = kNotKnown;  ///< root mean square of the residuals' lengths [m]
  /// Difference between the base found and the expected base, from which the search started: shift [m], then rotation
  /// vector [rad], in world axes.
  BaseStep from_start = BaseStep::Constant(kNotKnown);
};

/// Returns true if chi-square rejects the fit (p < 0.01): either the arm deviates from its model by more than the
/// uncertainty of its parameters, or a touch is in error.
[[nodiscard]] bool isFitRefused(const BaseCalibration& calibration);

/// Finds the base by fitTouches(), from any start. All touches must have known positions, a stated sigma and the same
/// set-up. If chi-square rejects the fit, the result still contains the residuals, and also the touches and joint
/// readings that may be wrong.
[[nodiscard]] BaseCalibration calibrateBase(const deflection::Arm& arm, const std::vector<Measurement>& touches,
                                            const Eigen::Isometry3d& X_WB_start,
                                            const BaseCalibrationOptions& options = {});

/// Returns the reason why these touches cannot determine a base (fewer than three holes, a hole touched twice under the
/// same load, holes almost on a line), or an empty string if they can.
std::string findTouchProblem(const std::vector<Measurement>& touches, const BaseCalibrationOptions& options = {});

}  // namespace tubeplan::calibration
