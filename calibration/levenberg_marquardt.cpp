// Levenberg-Marquardt with bounds: damped Gauss-Newton steps in the variables that no bound holds (Marquardt 1963; the
// damping of Nielsen 1999). Cheap to start, so it is what repeated refits use.
#include <algorithm>
#include <cmath>

#include "calibration/scaled_problem.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double kFirstDamping = 1e-6;  // of the largest diagonal of the normal equations
constexpr double kRest = 1e-12;         // of the same: what no residual depends on stays where it is
constexpr double kLargestDamping = 1e12;
constexpr double kNoMisfit = 1e-6;  // chi2 below which the tolerance is no longer a share of it

/// Variables at a bound that the gradient presses against take no part in a step.
std::vector<Index> movable(const ScaledProblem& problem, const VectorXd& x, const VectorXd& gradient) {
  std::vector<Index> free;
  for (Index k = 0; k < x.size(); ++k) {
    const bool is_pressed =
        (x[k] <= problem.lower()[k] && gradient[k] > 0) || (x[k] >= problem.upper()[k] && gradient[k] < 0);
    if (!is_pressed && problem.lower()[k] < problem.upper()[k]) free.push_back(k);
  }
  return free;
}

/// The damped step of the free variables; one that would leave its bounds goes to the bound, and the others are solved
/// for again with it there.
VectorXd dampedStep(const ScaledProblem& problem, const MatrixXd& normal, const VectorXd& gradient, const VectorXd& x,
                    std::vector<Index> free, double damping) {
  VectorXd step = VectorXd::Zero(gradient.size());
  while (!free.empty()) {
    MatrixXd some = normal(free, free);
    some.diagonal() += damping * some.diagonal();
    some.diagonal().array() += kRest * normal.diagonal().maxCoeff();
    const VectorXd pull = gradient + normal * step;
    const VectorXd part = some.ldlt().solve(-pull(free));
    std::vector<Index> inside;
    for (std::size_t k = 0; k < free.size(); ++k) {
      const Index v = free[k];
      const double to = x[v] + part[static_cast<Index>(k)];
      if (to >= problem.lower()[v] && to <= problem.upper()[v])
        inside.push_back(v);
      else
        step[v] = (to < problem.lower()[v] ? problem.lower()[v] : problem.upper()[v]) - x[v];
    }
    if (inside.size() == free.size()) {
      for (std::size_t k = 0; k < free.size(); ++k) step[free[k]] = part[static_cast<Index>(k)];
      break;
    }
    free = inside;
  }
  return step;
}

}  // namespace

LeastSquaresResult minimizeByLevenbergMarquardt(const LeastSquaresProblem& problem, const LeastSquaresStop& stop) {
  using Status = LeastSquaresStatus;
  ScaledProblem scaled(problem);
  VectorXd x = scaled.start(), r, next_r;
  MatrixXd jacobian, next_jacobian;
  if (!scaled.linearizeAt(x, r, jacobian)) return scaled.failureAtStart();
  double chi2 = r.squaredNorm(), damping = kFirstDamping, growth = 2;
  for (int iterations = 0;; ++iterations) {
    const MatrixXd normal = jacobian.transpose() * jacobian;
    const VectorXd gradient = jacobian.transpose() * r;
    const auto free = movable(scaled, x, gradient);
    if (free.empty())
      return scaled.resultAt(x, chi2, Status::kConverged, "every variable rests on a bound", iterations);
    if (iterations == stop.max_iterations)
      return scaled.resultAt(x, chi2, Status::kIterationLimit, "stopped at the iteration limit", iterations);
    double fall = 0, expected = 0;
    bool is_linear = false;
    while (true) {
      const VectorXd next = scaled.withinBounds(x + dampedStep(scaled, normal, gradient, x, free, damping));
      const VectorXd step = next - x;
      expected = -2 * gradient.dot(step) - step.dot(normal * step);
      if (std::abs(expected) <= stop.tolerance * std::max(chi2, kNoMisfit))
        return scaled.resultAt(x, chi2, Status::kConverged, "no step would lower chi2 by more than the tolerance",
                               iterations);
      // Most steps are taken, so the Jacobian comes with the value; after one that was not, the value alone.
      const bool is_first = growth == 2;
      is_linear = expected > 0 && is_first && scaled.linearizeAt(next, next_r, next_jacobian);
      const double tried = is_linear ? next_r.squaredNorm() : expected > 0 ? scaled.chi2At(next) : chi2;
      fall = chi2 - tried;
      if (fall > 0) {
        x = next;
        chi2 = tried;
        break;
      }
      damping = std::max(damping, kFirstDamping) * growth;
      growth *= 2;
      if (damping > kLargestDamping)
        return scaled.resultAt(x, chi2, Status::kConverged, "chi2 falls no further than by rounding", iterations);
    }
    damping *= std::max(1. / 9, 1 - std::pow(2 * fall / expected - 1, 3));
    growth = 2;
    if (is_linear) {
      r.swap(next_r);
      jacobian.swap(next_jacobian);
    } else if (!scaled.linearizeAt(x, r, jacobian)) {
      return scaled.resultAt(x, chi2, Status::kFailed, "the model could not be differentiated", iterations);
    }
    chi2 = r.squaredNorm();
  }
}

}  // namespace tubeplan::calibration
