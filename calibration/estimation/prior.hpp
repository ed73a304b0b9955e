// Prior knowledge in a fit and in the resulting uncertainty. Every free parameter has a normal prior
// (Unknown::prior_sigma), which enters least squares as one more residual, (x - mean) / sigma. The minimum is then the
// most probable state. Its posterior covariance C is the inverse of J^T J + Lambda, with Lambda = diag(1 / sigma^2). Of
// the n parameters, the measurements determine p = tr(C J^T J), the effective number of parameters (Spiegelhalter et
// al. 2002, "Bayesian measures of model complexity and fit").
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Returns the prior residual of each unknown, (x - mean) / sigma; 0 for an unknown without a prior.
[[nodiscard]] Eigen::VectorXd priorResiduals(const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x);

/// Returns the derivative of each prior residual with respect to its variable: 1 / sigma.
[[nodiscard]] Eigen::VectorXd priorSlopes(const std::vector<Unknown>& unknowns);

/// Returns the diagonal of the prior information matrix for the variables divided by their typical sizes: (typical /
/// sigma)^2.
[[nodiscard]] Eigen::VectorXd priorInformation(const std::vector<Unknown>& unknowns);

/// Returns the posterior covariance of the variables, given the whitened Jacobian of the measurements. It is zero for a
/// variable that neither the measurements nor its prior determine.
[[nodiscard]] Eigen::MatrixXd posteriorCovariance(const Eigen::MatrixXd& jacobian,
                                                  const std::vector<Unknown>& unknowns);

/// Returns the inverse of an information matrix, which must be positive definite; the scales of its variables may
/// differ widely.
[[nodiscard]] Eigen::MatrixXd inverseOfInformation(const Eigen::MatrixXd& information);

/// Returns the effective number of parameters that the measurements determine, from 0 to all, given the posterior
/// covariance.
[[nodiscard]] double effectiveNumbers(const Eigen::MatrixXd& covariance, const std::vector<Unknown>& unknowns);

/// Returns the rounded effective number of parameters, which is subtracted from the measurements' degrees of freedom.
[[nodiscard]] int numbersDetermined(const Eigen::MatrixXd& covariance, const std::vector<Unknown>& unknowns);

}  // namespace tubeplan::calibration
