// Fit of the base pose and of the arm's uncertain parameters to touches of known holes.
//
// Let z be the independent standard normal variables of the uncertain parameters (UncertainNumbers) and s a step of the
// base. The fit minimises
//     sum_k |L_k^-1 (tip_k(s, z) - hole_k)|^2 + |z|^2,
// where L_k L_k^T is the covariance of a touch: its own noise, encoder noise and the stated model error. In this way,
// the covariance of the base includes the uncertainty of the arm's parameters, and a touch moves the base only by the
// part of the touch error that these parameters do not explain. If they have their stated uncertainty, the minimum is
// chi-square distributed with 3 n - 6 degrees of freedom, where n is the number of touches.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/arm_uncertainty.hpp"
#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::calibration {

struct TouchFitOptions {
  /// Standard deviation of the model error per coordinate known beforehand [m], in addition to noise and uncertain
  /// parameters.
  double model_error = 0;
  /// True to increase the model error, if chi-square rejects the fit (p < 0.01), until chi-square equals its degrees of
  /// freedom.
  bool finds_model_error = true;
  LeastSquaresMethod method = LeastSquaresMethod::kHybrid;
};

/// Joint covariance of the base step (six variables, first) and of the variables of the arm's uncertain parameters.
struct JointUncertainty {
  std::vector<Unknown> numbers;
  Eigen::MatrixXd covariance;  ///< covariance of the base step and the parameters' variables, (6 + n) x (6 + n)
};

/// Base pose and parameters of the arm that were fitted to touches, with their uncertainty.
struct TouchedBase {
  int iterations = 0;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  deflection::Arm arm;           ///< arm with the fitted parameter values
  JointUncertainty uncertainty;  ///< joint uncertainty of base and parameters about X_WB and `arm`
  double model_error = 0;  ///< standard deviation of the model error per coordinate, included in `uncertainty` [m]
  bool is_model_error_found = false;  ///< true if the model error known beforehand was too small and was increased
  double chi2 = kNotKnown;            ///< chi-square of the fit with the model error known beforehand
  int degrees_of_freedom = 0;
  double p_value = kNotKnown;
};

struct TouchFit : TouchedBase {
  LeastSquaresStatus status = LeastSquaresStatus::kNotRun;
  std::string reason;                  ///< reason why the fit failed, if the status is not kConverged
  std::vector<Eigen::Matrix3d> noise;  ///< covariance of each touch due to its own noise and encoder noise [m^2]
  Eigen::Matrix3Xd error_W;            ///< tip minus hole of each touch, in world axes [m]
};

/// Fits base and parameters to three or more touches of known positions that are not on one line. X_WB_start may be far
/// off, because the base is first aligned with the touches in closed form.
[[nodiscard]] TouchFit fitTouches(const deflection::Arm& arm, const UncertainNumbers& numbers,
                                  const std::vector<Measurement>& touches, const Eigen::Isometry3d& X_WB_start,
                                  const TouchFitOptions& options = {});

/// Returns the joint uncertainty of base and parameters after a fit to these touches that ended at `arm` and `X_WB`;
/// empty if the arm's deflected shape does not converge. `model_error` [m] is as in TouchFit.
[[nodiscard]] std::optional<JointUncertainty> uncertaintyByTouches(const deflection::Arm& arm,
                                                                   const Eigen::Isometry3d& X_WB,
                                                                   const UncertainNumbers& numbers,
                                                                   const std::vector<Measurement>& touches,
                                                                   double model_error = 0);

}  // namespace tubeplan::calibration
