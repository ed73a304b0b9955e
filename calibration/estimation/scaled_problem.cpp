#include "calibration/estimation/scaled_problem.hpp"

namespace tubeplan::calibration {

using Eigen::MatrixXd, Eigen::VectorXd;

ScaledProblem::ScaledProblem(const LeastSquaresProblem& problem)
    : problem_(problem),
      lower_(problem.lower.cwiseQuotient(problem.scale)),
      upper_(problem.upper.cwiseQuotient(problem.scale)) {}

/// Returns the point in the problem's own units, clamped to the bounds, because rounding may move it beyond them.
VectorXd ScaledProblem::unscaled(const VectorXd& x) const {
  return x.cwiseProduct(problem_.scale).cwiseMax(problem_.lower).cwiseMin(problem_.upper);
}

double ScaledProblem::chi2At(const VectorXd& x) {
  ++evaluations_;
  VectorXd r;
  const double infinity = std::numeric_limits<double>::infinity();
  if (!problem_.evaluate(unscaled(x), r, nullptr)) return infinity;
  return r.allFinite() ? r.squaredNorm() : infinity;
}

bool ScaledProblem::linearizeAt(const VectorXd& x, VectorXd& r, MatrixXd& jacobian) {
  ++jacobian_evaluations_;
  if (!problem_.evaluate(unscaled(x), r, &jacobian)) return false;
  jacobian.array().rowwise() *= problem_.scale.transpose().array();
  return r.allFinite() && jacobian.allFinite();
}

LeastSquaresResult ScaledProblem::resultAt(const VectorXd& x, double chi2, LeastSquaresStatus status,
                                           std::string reason, int iterations) const {
  return {status, std::move(reason), unscaled(x), chi2, iterations, evaluations_, jacobian_evaluations_};
}

LeastSquaresResult ScaledProblem::failureAtStart() const {
  return resultAt(start(), std::numeric_limits<double>::quiet_NaN(), LeastSquaresStatus::kFailed,
                  "the model could not be evaluated at the start");
}

}  // namespace tubeplan::calibration
