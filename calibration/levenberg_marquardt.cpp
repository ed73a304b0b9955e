// Levenberg-Marquardt with bounds, as a trust region: Gauss-Newton steps in the variables that no bound holds, damped
// until they are no longer than the model has proved good for (Moré 1978, "The Levenberg-Marquardt algorithm:
// implementation and theory"). Cheap to start, so it is what repeated refits use.
#include <algorithm>
#include <cmath>

#include "calibration/scaled_problem.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double kFirstRadius = 1;      // of a typical size, in the mean over the variables
constexpr double kLeastRadius = 1e-14;  // of the same: shorter steps change nothing
constexpr double kRest = 1e-13;         // of a variable's own curvature: what only rounding would move stays
constexpr double kUnseen = 1e-30;       // of the largest curvature: what no residual depends on stays
constexpr double kLengthRest = 0.1;     // of the radius, by which a damped step may be longer
constexpr int kDampings = 20;           // tries to bring a step to the radius
constexpr double kNoMisfit = 1e-6;      // chi2 below which the tolerance is no longer a share of it
constexpr double kGood = 0.75, kPoor = 0.25;  // shares of the foretold fall for a longer, and for a shorter radius

/// Half of chi2's change by a step, to second order: gradient . step + step . normal step / 2.
struct Valley {
  VectorXd gradient;
  MatrixXd normal;

  void open(const MatrixXd& jacobian, const VectorXd& r) {
    gradient = jacobian.transpose() * r;
    normal = jacobian.transpose() * jacobian;
  }
  [[nodiscard]] double fallBy(const VectorXd& step) const { return -2 * gradient.dot(step) - step.dot(normal * step); }
};

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

/// -(normal + damping) \ pull; where it is to be no longer than `radius`, the damping grows until it is (Newton's
/// method on the length's inverse).
VectorXd dampedSolution(MatrixXd normal, const VectorXd& pull, double radius, double& damping) {
  normal.diagonal() *= 1 + kRest;
  normal.diagonal().array() += kUnseen * normal.diagonal().maxCoeff() + damping;
  Eigen::LLT<MatrixXd> factor;
  for (int k = 0;; ++k) {
    factor.compute(normal);
    VectorXd step = -factor.solve(pull);
    const double length = step.norm();
    if (length <= (1 + kLengthRest) * radius || k == kDampings) return step;
    const double more = (length - radius) / radius * length * length / factor.matrixL().solve(step).squaredNorm();
    normal.diagonal().array() += more;
    damping += more;
  }
}

/// The step of the free variables, of `radius` at most; what would leave its bounds goes to the bound, and the others
/// are solved for again with it there, under the same damping.
VectorXd boundedStep(const ScaledProblem& problem, const Valley& valley, const VectorXd& x, std::vector<Index> free,
                     double radius, double& damping) {
  VectorXd step = VectorXd::Zero(x.size());
  damping = 0;
  while (!free.empty()) {
    const VectorXd pull = valley.gradient + valley.normal * step;
    const VectorXd part = dampedSolution(valley.normal(free, free), pull(free), radius, damping);
    radius = std::numeric_limits<double>::infinity();
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

/// How far steps may go, by how well the last one was foretold.
double radiusAfter(double radius, double length, double fall, double foretold) {
  if (fall > kGood * foretold) return std::max(radius, 2 * length);
  return fall > kPoor * foretold ? radius : kPoor * std::min(radius, length);
}

}  // namespace

LeastSquaresResult minimizeByLevenbergMarquardt(const LeastSquaresProblem& problem, const LeastSquaresStop& stop) {
  using Status = LeastSquaresStatus;
  ScaledProblem scaled(problem);
  VectorXd x = scaled.start(), r, next_r;
  MatrixXd jacobian, next_jacobian;
  if (!scaled.linearizeAt(x, r, jacobian)) return scaled.failureAtStart();
  double chi2 = r.squaredNorm();
  const double size = std::sqrt(static_cast<double>(x.size()));
  double radius = kFirstRadius * size;
  for (int iterations = 0;; ++iterations) {
    Valley valley;
    valley.open(jacobian, r);
    const auto end = [&](Status status, const char* reason) {
      return scaled.resultAt(x, chi2, status, reason, iterations);
    };
    const auto free = movable(scaled, x, valley.gradient);
    if (free.empty()) return end(Status::kConverged, "every variable rests on a bound");
    if (iterations == stop.max_iterations) return end(Status::kIterationLimit, "stopped at the iteration limit");
    bool is_linear = false;
    for (int tries = 0;; ++tries) {
      double damping = 0;
      const VectorXd next = scaled.withinBounds(x + boundedStep(scaled, valley, x, free, radius, damping));
      const VectorXd step = next - x;
      const double foretold = valley.fallBy(step);
      if (damping == 0 && std::abs(foretold) <= stop.tolerance * std::max(chi2, kNoMisfit))
        return end(Status::kConverged, "no step would lower chi2 by more than the tolerance");
      // Most steps are taken, so the Jacobian comes with the value; after one that was not, the value alone.
      is_linear = foretold > 0 && tries == 0 && scaled.linearizeAt(next, next_r, next_jacobian);
      const double tried = is_linear ? next_r.squaredNorm() : foretold > 0 ? scaled.chi2At(next) : chi2;
      const double fall = chi2 - tried;
      radius = radiusAfter(radius, step.norm(), fall, foretold);
      if (fall > 0) {
        x = next;
        chi2 = tried;
        break;
      }
      if (radius <= kLeastRadius * size) return end(Status::kConverged, "chi2 falls no further than by rounding");
    }
    if (is_linear) {
      r.swap(next_r);
      jacobian.swap(next_jacobian);
    } else if (!scaled.linearizeAt(x, r, jacobian)) {
      return end(Status::kFailed, "the model could not be differentiated");
    }
    chi2 = r.squaredNorm();
  }
}

}  // namespace tubeplan::calibration
