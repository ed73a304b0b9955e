// Sensitivity of the tip to each number of the arm. It shows the designer which member to stiffen or lighten (Calkins
// 1994, section 6.3), and the calibrator how well each number must be known.
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

/// Postures where accuracy matters, and touches that place the base.
struct SensitivityTask {
  std::vector<Eigen::VectorXd> work;     ///< postures at work
  double load = 0;                       ///< hung on the tip at work; touches are made without load [N]
  std::vector<Eigen::VectorXd> touches;  ///< postures that place the base, three or more; none: the base is known
  double touch_sigma = 1.27e-4;          ///< per coordinate [m]
  DoubtBeside doubt = {};                ///< doubt of the arm, with which the touches are fitted
  /// Only components across it count as centring error; nothing: all components.
  std::optional<Eigen::Vector3d> hole_axis_W;
};

/// Sensitivities of a number, as means over the work postures at the same joint readings.
struct NumberSensitivity {
  deflection::Parameter parameter;
  NumberKind kind = NumberKind::kOther;
  /// Slope of the mean deflection by the number [m per unit].
  double deflection = std::numeric_limits<double>::quiet_NaN();
  /// Slope of the mean error without compensation [m per unit].
  double centring = std::numeric_limits<double>::quiet_NaN();
  /// Mean error at work, with compensation, for an unknown error of the number [m per unit]: with the base known, and
  /// with the base placed by touches. These absorb a part, in the base and in the numbers that are fitted with it.
  double error_base_known = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

enum class SensitivityStatus { kNotRun, kDone, kNotConverged, kTouchesTellNoBase };

struct Sensitivity {
  SensitivityStatus status = SensitivityStatus::kNotRun;
  std::string reason;
  double mean_deflection = std::numeric_limits<double>::quiet_NaN();  ///< [m]
  /// Mean error at work by rigid kinematics, with the base placed by the touches in the same way [m].
  double mean_uncompensated = std::numeric_limits<double>::quiet_NaN();
  std::vector<NumberSensitivity> numbers;  ///< every number of the arm, in file order
};

/// Computes the sensitivities. Derivatives are exact, except that of the uncompensated error, which is a central
/// difference of one part in a thousand (NaN for numbers that are zero).
[[nodiscard]] Sensitivity findSensitivities(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                            const SensitivityTask& task);

/// Returns the mean distance from the rigid to the deflected tip over the work [m]; NaN if a shape does not converge.
[[nodiscard]] double meanDeflection(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                    const SensitivityTask& task);

/// Returns the mean error over the work [m] of an arm sent by rigid kinematics on a base that rigid kinematics placed
/// by the touches: the part of the deflection that no small motion of the base removes.
[[nodiscard]] double meanUncompensatedError(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                            const SensitivityTask& task);

}  // namespace tubeplan::calibration
