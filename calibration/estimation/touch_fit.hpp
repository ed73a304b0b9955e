// The most probable base, and the most probable numbers of the arm beside it, by touches of known holes.
//
// With z the numbers as independent standard normals (UncertainNumbers) and s a step of the base, the fit minimises
//     sum_k |L_k^-1 (tip_k(s, z) - hole_k)|^2 + |z|^2,
// L_k L_k^T the covariance of a touch by its own noise, its encoders' and the model's stated error. The uncertainty of
// the arm's file is so part of the base's covariance: a touch moves the base only by the part of its error that the
// arm's numbers cannot explain. The minimum has 3 n - 6 degrees of freedom if the numbers have their stated
// uncertainty.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/arm_uncertainty.hpp"
#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::calibration {

struct TouchFitOptions {
  double model_error = 0;  ///< per coordinate beyond noise and numbers, known beforehand [m]
  /// True: if chi-square rejects that (p < 0.01), the model error is increased as it requires.
  bool finds_model_error = true;
  LeastSquaresMethod method = LeastSquaresMethod::kHybrid;
};

/// Variables that are uncertain together and zero at the present base and arm: the base's six first, then numbers.
struct JointUncertainty {
  std::vector<Unknown> numbers;
  Eigen::MatrixXd covariance;  ///< (6 + n) x (6 + n), of the base's step and of the numbers' variables
};

/// Base and arm as touches have them.
struct TouchedBase {
  int iterations = 0;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  deflection::Arm arm;                ///< with its numbers where the touches have them: the one that stands at X_WB
  JointUncertainty uncertainty;       ///< about X_WB and `arm`
  double model_error = 0;             ///< m per coordinate, as counted
  bool is_model_error_found = false;  ///< by these touches: it is more than was known beforehand
  double chi2 = kNotKnown;            ///< by what was known beforehand
  int degrees_of_freedom = 0;
  double p_value = kNotKnown;
};

struct TouchFit : TouchedBase {
  LeastSquaresStatus status = LeastSquaresStatus::kNotRun;
  std::string reason;                  ///< why it is not kConverged
  std::vector<Eigen::Matrix3d> noise;  ///< of each touch by its own noise and its encoders' [m^2]
  Eigen::Matrix3Xd error_W;            ///< tip less hole of each touch [m]
};

/// Fits touches of known places, three or more and not on a line, from a base nearby or, after an alignment, from
/// anywhere.
[[nodiscard]] TouchFit fitTouches(const deflection::Arm& arm, const UncertainNumbers& numbers,
                                  const std::vector<Measurement>& touches, const Eigen::Isometry3d& X_WB_start,
                                  const TouchFitOptions& options = {});

/// Returns the remaining uncertainty of a base and an arm that were calibrated by these touches; nothing if a shape
/// does not converge. `model_error` [m] as in TouchFit.
[[nodiscard]] std::optional<JointUncertainty> uncertaintyByTouches(const deflection::Arm& arm,
                                                                   const Eigen::Isometry3d& X_WB,
                                                                   const UncertainNumbers& numbers,
                                                                   const std::vector<Measurement>& touches,
                                                                   double model_error = 0);

}  // namespace tubeplan::calibration
