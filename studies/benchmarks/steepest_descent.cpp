// Steepest descent with a line search (Calkins 1994, section 5.3.3), projected onto the bounds (Bertsekas 1976). The
// first trial step of each search is slightly shorter than the Cauchy step, which minimises chi2 along the gradient for
// linear residuals but zigzags at full length (Raydan and Svaiter 2002). The step is reduced by the golden ratio until
// chi2 meets Armijo's condition.
#include <cmath>
#include <numbers>

#include "calibration/estimation/scaled_problem.hpp"
#include "studies/benchmarks/thesis_methods.hpp"

namespace tubeplan::benchmarks {

namespace {

using calibration::LeastSquaresProblem, calibration::LeastSquaresResult, calibration::ScaledProblem;
using Eigen::MatrixXd, Eigen::VectorXd;
constexpr double kShareOfCauchyStep = 0.8;
constexpr double kArmijo = 1e-4;
constexpr int kMaxTrials = 80;  // reductions by the golden ratio, down to 1e-17 of the Cauchy step
constexpr double kLeastGradient = 1e-6;
constexpr int kMostIterations = 1000;
constexpr double kHiddenByRounding = 1e-9;  // relative change of chi2 that rounding errors of the model may conceal

struct SlopedPlace {
  VectorXd x, r;
  MatrixXd jacobian;
  double chi2() const { return r.squaredNorm(); }
  VectorXd gradient() const { return jacobian.transpose() * r; }
};

/// Returns the negative gradient, without the components that point out of an active bound.
VectorXd downhill(const ScaledProblem& problem, const SlopedPlace& place) {
  VectorXd direction = -place.gradient();
  for (Eigen::Index k = 0; k < direction.size(); ++k)
    if ((place.x[k] <= problem.lower()[k] && direction[k] < 0) ||
        (place.x[k] >= problem.upper()[k] && direction[k] > 0))
      direction[k] = 0;
  return direction;
}

/// Moves `x` to a point of sufficiently lower chi2 and returns true; false if none is found along the direction.
bool searchLine(ScaledProblem& problem, const SlopedPlace& from, const VectorXd& direction, double stride,
                VectorXd& x) {
  const VectorXd gradient = from.gradient();
  for (int trial = 0; trial < kMaxTrials; ++trial, stride /= std::numbers::phi) {
    x = problem.withinBounds(from.x + stride * direction);
    const double chi2 = problem.chi2At(x);
    if (chi2 < from.chi2() && chi2 <= from.chi2() + 2 * kArmijo * gradient.dot(x - from.x)) return true;
  }
  return false;
}

}  // namespace

LeastSquaresResult minimizeBySteepestDescent(const LeastSquaresProblem& problem) {
  using Status = calibration::LeastSquaresStatus;
  ScaledProblem scaled(problem);
  SlopedPlace current{scaled.start(), {}, {}};
  if (!scaled.linearizeAt(current.x, current.r, current.jacobian)) return scaled.failureAtStart();
  for (int iterations = 0;; ++iterations) {
    const auto stopped = [&](Status status, const char* reason) {
      return scaled.resultAt(current.x, current.chi2(), status, reason, iterations);
    };
    const VectorXd direction = downhill(scaled, current);
    if (direction.lpNorm<Eigen::Infinity>() <= kLeastGradient)
      return stopped(Status::kConverged, "the gradient is within tolerance");
    const double cauchy = direction.squaredNorm() / (current.jacobian * direction).squaredNorm();
    if (iterations == kMostIterations) return stopped(Status::kIterationLimit, "stopped at the iteration limit");
    SlopedPlace next;
    if (!searchLine(scaled, current, direction, kShareOfCauchyStep * cauchy, next.x))
      return cauchy * direction.squaredNorm() <= kHiddenByRounding * current.chi2()
                 ? stopped(Status::kConverged, "chi2 falls only within rounding")
                 : stopped(Status::kFailed, "no step lowers the error");
    if (!scaled.linearizeAt(next.x, next.r, next.jacobian))
      return stopped(Status::kFailed, "the model could not be differentiated");
    current = next;
  }
}

}  // namespace tubeplan::benchmarks
