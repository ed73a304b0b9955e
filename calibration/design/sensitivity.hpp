// What each number of the arm does to the tip: for the designer, which member to stiffen or lighten (Calkins 1994,
// section 6.3); for whoever calibrates, which number must be known how well.
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

/// Where accuracy counts, and what places the base.
struct SensitivityTask {
  std::vector<Eigen::VectorXd> work;           ///< postures at work
  double load = 0;                             ///< N, hung on the tip at work; touches are made without
  std::vector<Eigen::VectorXd> touches;        ///< postures that place the base, three or more; none: the base is known
  double touch_sigma = 1.27e-4;                ///< m per coordinate
  DoubtBeside doubt = {};                      ///< of the arm, beside which the touches are fitted
  std::optional<Eigen::Vector3d> hole_axis_W;  ///< only what is across it counts as centring error; none: all of it
};

/// Means are over the work postures, at the same joint readings.
struct NumberSensitivity {
  deflection::Parameter parameter;
  NumberKind kind = NumberKind::kOther;
  double deflection = std::numeric_limits<double>::quiet_NaN();  ///< of the mean deflection by the number [m per unit]
  double centring = std::numeric_limits<double>::quiet_NaN();  ///< of the mean error without compensation [m per unit]
  /// Mean error at work, with compensation, for an unknown error of the number [m per unit]: the base being known, and
  /// placed by the touches, which absorb a part, in the base and in the numbers beside which they are fitted.
  double error_base_known = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

enum class SensitivityStatus { kNotRun, kDone, kNotConverged, kTouchesTellNoBase };

struct Sensitivity {
  SensitivityStatus status = SensitivityStatus::kNotRun;
  std::string reason;
  double mean_deflection = std::numeric_limits<double>::quiet_NaN();  ///< m
  /// Mean error at work by rigid kinematics, the base placed by the touches with them too [m].
  double mean_uncompensated = std::numeric_limits<double>::quiet_NaN();
  std::vector<NumberSensitivity> numbers;  ///< every number of the arm, in file order
};

/// Derivatives are exact but that of the uncompensated error, a central difference of one part in a thousand (NaN for
/// numbers that are zero).
[[nodiscard]] Sensitivity findSensitivities(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                            const SensitivityTask& task);

/// Mean distance from the rigid to the deflected tip over the work [m]; NaN where a shape does not converge.
[[nodiscard]] double meanDeflection(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                    const SensitivityTask& task);

/// Mean error over the work when the arm is sent by rigid kinematics on a base that rigid kinematics placed by the
/// touches: the part of the deflection that no small move of the base takes off [m].
[[nodiscard]] double meanUncompensatedError(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                            const SensitivityTask& task);

}  // namespace tubeplan::calibration
