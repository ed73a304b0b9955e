// Prior knowledge in a fit and in its uncertainty: every free number has a normal prior
// (Unknown::prior_sigma), which enters least squares as one more residual, (x - mean) / sigma. The optimum is then the
// most probable state, the inverse of J^T J + Lambda its posterior covariance (Lambda = diag(1 / sigma^2)), and the
// readings determine p = tr(C J^T J) of the n numbers: the effective number of parameters (Spiegelhalter et al. 2002,
// "Bayesian measures of model complexity and fit").
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Returns one residual for each unknown; 0 for one without a prior.
[[nodiscard]] Eigen::VectorXd priorResiduals(const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x);

/// Returns the slope of each residual by its own variable: 1 / sigma.
[[nodiscard]] Eigen::VectorXd priorSlopes(const std::vector<Unknown>& unknowns);

/// Returns what the priors say of each variable over its typical size: (typical / sigma)^2.
[[nodiscard]] Eigen::VectorXd priorInformation(const std::vector<Unknown>& unknowns);

/// Posterior covariance of the variables by the whitened Jacobian of the readings; zero for what neither readings nor a
/// prior determine.
[[nodiscard]] Eigen::MatrixXd posteriorCovariance(const Eigen::MatrixXd& jacobian,
                                                  const std::vector<Unknown>& unknowns);

/// Returns the inverse of an information matrix that determines every variable; their sizes may be very different.
[[nodiscard]] Eigen::MatrixXd inverseOfInformation(const Eigen::MatrixXd& information);

/// Returns how many of the numbers the readings determine, by the posterior covariance: from 0 to all.
[[nodiscard]] double effectiveNumbers(const Eigen::MatrixXd& covariance, const std::vector<Unknown>& unknowns);

/// Returns the rounded effective number, which is subtracted from the readings' degrees of freedom.
[[nodiscard]] int numbersDetermined(const Eigen::MatrixXd& covariance, const std::vector<Unknown>& unknowns);

}  // namespace tubeplan::calibration
