// The table of least-squares methods, and the treatment of problems that need no solver.
#include "calibration/estimation/least_squares.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "calibration/estimation/scaled_problem.hpp"

namespace tubeplan::calibration {

namespace {

bool isWellFormed(const LeastSquaresProblem& problem) {
  const Eigen::Index n = problem.start.size();
  return problem.lower.size() == n && problem.upper.size() == n && problem.scale.size() == n &&
         problem.start.allFinite() && (problem.scale.array() > 0).all() && problem.evaluate;
}

LeastSquaresResult evaluateFixed(const LeastSquaresProblem& problem) {
  ScaledProblem scaled(problem);
  const Eigen::VectorXd x = scaled.start();
  const double chi2 = scaled.chi2At(x);
  return std::isfinite(chi2) ? scaled.resultAt(x, chi2, LeastSquaresStatus::kConverged, "every variable is fixed")
                             : scaled.failureAtStart();
}

/// Minimises with an `evaluate` that fails once a stop is requested, which makes any method end soon.
LeastSquaresResult minimizeUntilStopped(const LeastSquaresMethodKind& kind, const LeastSquaresProblem& problem,
                                        const LeastSquaresStop& stop, const LeastSquaresOptions& options) {
  bool is_stopped = false;
  LeastSquaresProblem stoppable = problem;
  stoppable.evaluate = [&](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) {
    is_stopped = is_stopped || options.stop();
    try {
      return !is_stopped && problem.evaluate(x, r, jacobian);
    } catch (const WorkStopped&) {  // exceptions must not propagate through a third-party solver
      is_stopped = true;
      return false;
    }
  };
  LeastSquaresResult result = kind.minimize(stoppable, stop, options.observe);
  if (is_stopped) {
    result.status = LeastSquaresStatus::kStopped;
    result.reason = kStoppedReason;
  }
  return result;
}

}  // namespace

std::span<const LeastSquaresMethodKind> leastSquaresMethods() {
  using Method = LeastSquaresMethod;
  static constexpr std::array kMethods{
      // Levenberg-Marquardt; if it does not converge soon, also the interior point method.
      LeastSquaresMethodKind{Method::kHybrid, "in-turn", {1e-9, 400}, minimizeHybrid},
      // Ipopt on the Gauss-Newton Hessian, until the gradient is within tolerance.
      LeastSquaresMethodKind{Method::kInteriorPoint, "ipopt", {1e-10, 200}, minimizeByInteriorPoint},
      // Damped Gauss-Newton, until no step would lower chi2 by more than the relative tolerance.
      LeastSquaresMethodKind{
          Method::kLevenbergMarquardt, "levenberg-marquardt", {1e-9, 100}, minimizeByLevenbergMarquardt},
  };
  return kMethods;
}

LeastSquaresResult minimizeLeastSquares(const LeastSquaresProblem& problem, const LeastSquaresOptions& options) {
  assert(isWellFormed(problem));
  if ((problem.lower.array() > problem.upper.array()).any()) {
    LeastSquaresResult refused;
    refused.status = LeastSquaresStatus::kFailed;
    refused.reason = "a lower bound lies above its upper bound";
    refused.x = problem.start;
    return refused;
  }
  if ((problem.lower.array() == problem.upper.array()).all()) return evaluateFixed(problem);
  const auto kinds = leastSquaresMethods();
  const auto kind = std::ranges::find_if(kinds, [&](const auto& k) { return k.method == options.method; });
  assert(kind != kinds.end());
  const LeastSquaresStop stop{options.tolerance.value_or(kind->stop.tolerance),
                              options.max_iterations.value_or(kind->stop.max_iterations)};
  assert(stop.tolerance > 0 && stop.max_iterations >= 0);
  return options.stop ? minimizeUntilStopped(*kind, problem, stop, options)
                      : kind->minimize(problem, stop, options.observe);
}

}  // namespace tubeplan::calibration
