// What is known beforehand, in a fit and in its uncertainty: every free number has a normal prior
// (Unknown::prior_sigma), which enters least squares as one more residual, (x - mean) / sigma. The optimum is then the
// most probable state, the inverse of J^T J + Lambda its posterior covariance (Lambda = diag(1 / sigma^2)), and the
// readings determine p = tr(C J^T J) of the n numbers: the effective number of parameters (Spiegelhalter et al. 2002,
// "Bayesian measures of model complexity and fit").
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// One residual for each unknown; 0 for one without a prior.
[[nodiscard]] Eigen::VectorXd priorResiduals(const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x);

/// Slope of each by its own variable: 1 / sigma.
[[nodiscard]] Eigen::VectorXd priorSlopes(const std::vector<Unknown>& unknowns);

/// Posterior covariance of the variables by the whitened Jacobian of the readings; zero for what neither readings nor a
/// prior determine.
[[nodiscard]] Eigen::MatrixXd posteriorCovariance(const Eigen::MatrixXd& jacobian,
                                                  const std::vector<Unknown>& unknowns);

/// Returns the inverse of an information matrix that determines every variable; they may be of very different sizes.
[[nodiscard]] Eigen::MatrixXd inverseOfInformation(const Eigen::MatrixXd& information);

/// How many of the numbers the readings determine, by the posterior covariance: from 0 to all.
[[nodiscard]] double effectiveNumbers(const Eigen::MatrixXd& covariance, const std::vector<Unknown>& unknowns);

/// The same rounded, as the readings' degrees of freedom lose by them.
[[nodiscard]] int numbersDetermined(const Eigen::MatrixXd& covariance, const std::vector<Unknown>& unknowns);

}  // namespace tubeplan::calibration
