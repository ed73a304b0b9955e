// Sensitivity of the tip position to each parameter of the arm. It shows which member a designer should stiffen or
// lighten (Calkins 1994, section 6.3), and how accurately a calibration must determine each parameter.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/estimate.hpp"
#include "deflection/parameters.hpp"

namespace tubeplan::calibration {

enum class NumberKind { kStiffness, kWeight, kLength, kOther };

/// Work postures, where accuracy matters, and the touches that determine the base pose.
struct SensitivityTask {
  std::vector<Eigen::VectorXd> work;  ///< joint readings of the work postures [rad, m]
  double load = 0;  ///< load hung from the tip at the work postures [N]; touches are made without load
  /// Joint readings of the touches that determine the base, three or more; empty means that the base is known.
  std::vector<Eigen::VectorXd> touches;
  double touch_sigma = 1.27e-4;  ///< standard deviation of each coordinate of a touch [m]
  AdditionalUncertainty additional =
      {};  ///< prior uncertainty of the arm, which the fit of the touches takes into account
  /// Axis of the holes. Only components perpendicular to it count as centring error; empty means that all components
  /// count.
  std::optional<Eigen::Vector3d> hole_axis_W;
};

/// Sensitivities of the tip to one parameter, averaged over the work postures at fixed joint readings.
struct NumberSensitivity {
  deflection::Parameter parameter;
  NumberKind kind = NumberKind::kOther;
  /// Derivative of the mean deflection with respect to the parameter [m per unit].
  double deflection = std::numeric_limits<double>::quiet_NaN();
  /// Derivative, with respect to the parameter, of the mean centring error without compensation of the deflection [m
  /// per unit].
  double centring = std::numeric_limits<double>::quiet_NaN();
  /// Mean centring error, with deflection compensation, per unit error of the parameter [m per unit]:
  /// `error_base_known` if the base is known, `error` if it is calibrated by touches. Calibration absorbs a part of the
  /// error.
  double error_base_known = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

enum class SensitivityStatus { kNotRun, kDone, kNotConverged, kTouchesDoNotDetermineBase };

struct Sensitivity {
  SensitivityStatus status = SensitivityStatus::kNotRun;
  std::string reason;
  double mean_deflection = std::numeric_limits<double>::quiet_NaN();  ///< mean deflection over the work postures [m]
  /// Mean centring error at the work postures [m] if rigid kinematics is used throughout, including the fit of the base
  /// to the touches.
  double mean_uncompensated = std::numeric_limits<double>::quiet_NaN();
  std::vector<NumberSensitivity> numbers;  ///< sensitivities to each parameter of the arm, in file order
};

/// Computes the sensitivities to all parameters. Derivatives are exact, except for the uncompensated error. Its
/// derivative is a central difference with a step of one thousandth of the parameter (NaN if the parameter is zero).
[[nodiscard]] Sensitivity findSensitivities(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                            const SensitivityTask& task);

/// Returns the mean distance between the tips of the rigid and of the deflected arm over the work postures [m]; NaN if
/// the deflected shape does not converge.
[[nodiscard]] double meanDeflection(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                    const SensitivityTask& task);

/// Returns the mean centring error over the work postures [m] without deflection compensation. Rigid kinematics is used
/// both to fit the base to the touches and to move the arm, so the fitted base absorbs part of the deflection. NaN if
/// the deflected shape does not converge.
[[nodiscard]] double meanUncompensatedError(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                            const SensitivityTask& task);

}  // namespace tubeplan::calibration
