// Sensitivity of the tip to each parameter of the arm. It shows designers which member to stiffen or lighten (Calkins
// 1994, section 6.3), and how accurately a calibration must determine each parameter.
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
  double load = 0;  ///< load hung from the tip in the work postures; touches are made without load [N]
  /// Joint readings of the touches that determine the base, three or more; empty: the base is known.
  std::vector<Eigen::VectorXd> touches;
  double touch_sigma = 1.27e-4;  ///< standard deviation of each coordinate of a touch [m]
  DoubtBeside doubt = {};        ///< prior uncertainty of the arm, which the fit of the touches takes into account
  /// Axis of the holes: only error components perpendicular to it count as centring error; empty: all components count.
  std::optional<Eigen::Vector3d> hole_axis_W;
};

/// Sensitivities to one parameter, as means over the work postures at fixed joint readings.
struct NumberSensitivity {
  deflection::Parameter parameter;
  NumberKind kind = NumberKind::kOther;
  /// Derivative of the mean deflection with respect to the parameter [m per unit].
  double deflection = std::numeric_limits<double>::quiet_NaN();
  /// Derivative, with respect to the parameter, of the mean error if the deflection is not compensated [m per unit].
  double centring = std::numeric_limits<double>::quiet_NaN();
  /// Mean error [m per unit] at the work postures, with the deflection compensated, per unit of an unknown error of the
  /// parameter: `error_base_known` if the base is known, `error` if touches determine it. The fit of the touches
  /// absorbs part of the error in the base and in the parameters fitted with it.
  double error_base_known = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

enum class SensitivityStatus { kNotRun, kDone, kNotConverged, kTouchesTellNoBase };

struct Sensitivity {
  SensitivityStatus status = SensitivityStatus::kNotRun;
  std::string reason;
  double mean_deflection = std::numeric_limits<double>::quiet_NaN();  ///< mean deflection over the work postures [m]
  /// Mean error at the work postures with rigid kinematics, for a base also determined from the touches by rigid
  /// kinematics [m].
  double mean_uncompensated = std::numeric_limits<double>::quiet_NaN();
  std::vector<NumberSensitivity> numbers;  ///< sensitivities to every parameter of the arm, in file order
};

/// Computes the sensitivities. Derivatives are exact, except that of the uncompensated error. It is a central
/// difference with a step of one thousandth of the parameter (NaN for a parameter that is zero).
[[nodiscard]] Sensitivity findSensitivities(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                            const SensitivityTask& task);

/// Returns the mean distance between the rigid and the deflected tip over the work postures [m]; NaN if a shape does
/// not converge.
[[nodiscard]] double meanDeflection(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                    const SensitivityTask& task);

/// Returns the mean error over the work postures [m] if rigid kinematics both determines the base from the touches and
/// moves the arm: the part of the deflection that remains after the base has been fitted to the touches. NaN if a shape
/// does not converge.
[[nodiscard]] double meanUncompensatedError(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                            const SensitivityTask& task);

}  // namespace tubeplan::calibration
