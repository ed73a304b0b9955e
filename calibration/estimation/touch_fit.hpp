// The most probable base pose, and the most probable parameters of the arm, given touches of known holes.
//
// Let z be the parameters as independent standard normal variables (UncertainNumbers) and s a step of the base. The fit
// minimises
//     sum_k |L_k^-1 (tip_k(s, z) - hole_k)|^2 + |z|^2,
// where L_k L_k^T is the covariance of a touch: its own noise, encoder noise and the stated model error. In this way,
// the covariance of the base includes the uncertainty of the arm's parameters, and a touch moves the base only by the
// part of its error that these parameters do not explain. If they have their stated uncertainty, the minimum is
// chi-square distributed with 3 n - 6 degrees of freedom, where n is the number of touches.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/arm_uncertainty.hpp"
#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::calibration {

struct TouchFitOptions {
  /// Standard deviation of the model error per coordinate beyond noise and parameters, known beforehand [m].
  double model_error = 0;
  /// True: if chi-square rejects the fit (p < 0.01), the model error is increased as far as needed.
  bool finds_model_error = true;
  LeastSquaresMethod method = LeastSquaresMethod::kHybrid;
};

/// Jointly uncertain variables, all zero at the present base and arm: the six of the base first, then those of the
/// arm's parameters.
struct JointUncertainty {
  std::vector<Unknown> numbers;
  Eigen::MatrixXd covariance;  ///< covariance of the base step and the parameters' variables, (6 + n) x (6 + n)
};

/// Base and arm as determined by touches.
struct TouchedBase {
  int iterations = 0;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  deflection::Arm arm;           ///< arm with the parameter values found from the touches
  JointUncertainty uncertainty;  ///< joint uncertainty of base and parameters about X_WB and `arm`
  double model_error = 0;  ///< standard deviation of the model error per coordinate, included in `uncertainty` [m]
  bool is_model_error_found = false;  ///< true: these touches require a larger model error than was known beforehand
  double chi2 = kNotKnown;            ///< chi-square with the model error known beforehand
  int degrees_of_freedom = 0;
  double p_value = kNotKnown;
};

struct TouchFit : TouchedBase {
  LeastSquaresStatus status = LeastSquaresStatus::kNotRun;
  std::string reason;                  ///< reason if the status is not kConverged
  std::vector<Eigen::Matrix3d> noise;  ///< covariance of each touch due to its own noise and encoder noise [m^2]
  Eigen::Matrix3Xd error_W;            ///< tip minus hole of each touch, in world axes [m]
};

/// Fits three or more touches of known positions, not on one line. The start may be far off, because the base is first
/// aligned with the touches in closed form.
[[nodiscard]] TouchFit fitTouches(const deflection::Arm& arm, const UncertainNumbers& numbers,
                                  const std::vector<Measurement>& touches, const Eigen::Isometry3d& X_WB_start,
                                  const TouchFitOptions& options = {});

/// Returns the joint uncertainty that remains after a base and an arm were calibrated with these touches; empty if a
/// shape does not converge. `model_error` [m] is as in TouchFit.
[[nodiscard]] std::optional<JointUncertainty> uncertaintyByTouches(const deflection::Arm& arm,
                                                                   const Eigen::Isometry3d& X_WB,
                                                                   const UncertainNumbers& numbers,
                                                                   const std::vector<Measurement>& touches,
                                                                   double model_error = 0);

}  // namespace tubeplan::calibration
