// Levenberg-Marquardt with bounds, as a trust-region method: Gauss-Newton steps in the variables not held by a bound,
// damped until they are no longer than the radius within which the quadratic model has proved accurate (Moré 1978, "The
// Levenberg-Marquardt algorithm: implementation and theory"). Repeated refits use this method because it starts
// quickly.
#include <algorithm>
#include <cmath>

#include "calibration/estimation/scaled_problem.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double kFirstRadius = 1;  // initial radius: root mean square step of the scaled variables
// Smallest radius, in the same measure; shorter steps are lost in rounding.
constexpr double kLeastRadius = 1e-14;
// Relative increase of each diagonal element of the normal matrix, to suppress steps caused by rounding errors.
constexpr double kRest = 1e-13;
// Increase of all diagonal elements, as a fraction of the largest, so that variables that affect no residual do not
// move.
constexpr double kLeastDamping = 1e-30;
constexpr double kLengthRest = 0.1;  // a damped step may exceed the radius by this fraction
constexpr int kDampings = 20;        // maximum number of attempts to adapt the damping to the radius
// Maximum number of times that the damping is doubled to make the damped matrix positive definite.
constexpr int kFactorisations = 100;
constexpr double kNoLackOfFit = 1e-6;  // lower bound on the chi2 to which the tolerance is relative
// The radius grows if chi2 decreases by more than the fraction kGood of the predicted decrease, and shrinks below
// kPoor.
constexpr double kGood = 0.75, kPoor = 0.25;

/// Quadratic model of half the change of chi2 due to a step: gradient . step + step . normal step / 2.
struct QuadraticModel {
  VectorXd gradient;
  MatrixXd normal;

  void open(const MatrixXd& jacobian, const VectorXd& r) {
    gradient = jacobian.transpose() * r;
    normal = jacobian.transpose() * jacobian;
  }
  [[nodiscard]] double predictedReduction(const VectorXd& step) const {
    return -2 * gradient.dot(step) - step.dot(normal * step);
  }
};

/// Returns the indices of the variables that a step may change: all except fixed ones and those at a bound that
/// steepest descent would cross.
std::vector<Index> movable(const ScaledProblem& problem, const VectorXd& x, const VectorXd& gradient) {
  std::vector<Index> free;
  for (Index k = 0; k < x.size(); ++k) {
    const bool is_pressed =
        (x[k] <= problem.lower()[k] && gradient[k] > 0) || (x[k] >= problem.upper()[k] && gradient[k] < 0);
    if (!is_pressed && problem.lower()[k] < problem.upper()[k]) free.push_back(k);
  }
  return free;
}

/// Returns -(normal + damping I)^-1 gradient. If its length exceeds `radius`, increases `damping` until it no longer
/// does (by Newton's method on the inverse of the length).
VectorXd dampedSolution(MatrixXd normal, const VectorXd& gradient, double radius, double& damping) {
  normal.diagonal() *= 1 + kRest;
  normal.diagonal().array() += kLeastDamping * normal.diagonal().maxCoeff() + damping;
  Eigen::LLT<MatrixXd> factor;
  int indefinite = 0;
  for (int k = 0; k <= kDampings; ++k) {
    factor.compute(normal);
    if (factor.info() != Eigen::Success) {  // not positive definite because of rounding; needs more damping
      if (++indefinite > kFactorisations) break;
      const double more = std::max(damping, kRest * normal.diagonal().maxCoeff());
      normal.diagonal().array() += more;
      damping += more;
      --k;
      continue;
    }
    VectorXd step = -factor.solve(gradient);
    const double length = step.norm();
    if (length <= (1 + kLengthRest) * radius || k == kDampings) return step;
    const double more = (length - radius) / radius * length * length / factor.matrixL().solve(step).squaredNorm();
    normal.diagonal().array() += more;
    damping += more;
  }
  return VectorXd::Zero(gradient.size());
}

/// Returns the step of the variables `free`, damped to a length of at most `radius`. If variables would leave their
/// bounds, they are set to these, and the step of the others is computed again with the same damping.
VectorXd boundedStep(const ScaledProblem& problem, const QuadraticModel& model, const VectorXd& x,
                     std::vector<Index> free, double radius, double& damping) {
  VectorXd step = VectorXd::Zero(x.size());
  damping = 0;
  while (!free.empty()) {
    const VectorXd gradient = model.gradient + model.normal * step;
    const VectorXd part = dampedSolution(model.normal(free, free), gradient(free), radius, damping);
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

/// State of one minimisation: the current point x_ with its residual and Jacobian, and the trust radius.
class TrustRegionMinimizer {
 public:
  TrustRegionMinimizer(const LeastSquaresProblem& problem, const IterationObserver& observe)
      : scaled_(problem), observe_(observe), x_(scaled_.start()), size_(std::sqrt(static_cast<double>(x_.size()))) {}

  LeastSquaresResult run(const LeastSquaresStop& stop);

 private:
  enum class Step { kTaken, kAtRest, kOnlyRounding };

  Step step(double tolerance);
  bool moveTo(const VectorXd& next, double predicted, bool is_first);
  void adaptRadius(double length, double fall, double predicted);
  [[nodiscard]] LeastSquaresResult end(LeastSquaresStatus status, const char* reason) const {
    return scaled_.resultAt(x_, chi2_, status, reason, iterations_);
  }

  ScaledProblem scaled_;
  const IterationObserver& observe_;
  VectorXd x_, r_, next_r_;
  MatrixXd jacobian_, next_jacobian_;
  double size_;
  double radius_ = kFirstRadius * size_;
  double chi2_ = std::numeric_limits<double>::quiet_NaN();
  QuadraticModel model_;
  std::vector<Index> free_;
  double last_fall_ = std::numeric_limits<double>::infinity();
  bool is_linear_ = true;  ///< true if r_ and jacobian_ have been computed at x_
  int iterations_ = 0;
  double length_ = 0, damping_ = 0;  ///< length and damping of the last step taken
};

/// Adapts the radius after a step, given the actual and the predicted decrease of chi2.
void TrustRegionMinimizer::adaptRadius(double length, double fall, double predicted) {
  const double share = fall > 0 ? fall / predicted : 0;  // `predicted` may be negative if bounds limit the step
  if (share > kGood)
    radius_ = std::max(radius_, 2 * length);
  else if (!(share > kPoor))
    radius_ = kPoor * std::min(radius_, length);
}

/// Moves x_ to `next` if chi2 is smaller there. Returns true if it moved. A first trial usually succeeds and therefore
/// computes the Jacobian at once; trials after a rejected step compute only chi2.
bool TrustRegionMinimizer::moveTo(const VectorXd& next, double predicted, bool is_first) {
  const bool is_linear = predicted > 0 && is_first && scaled_.linearizeAt(next, next_r_, next_jacobian_);
  const double tried = is_linear ? next_r_.squaredNorm() : predicted > 0 ? scaled_.chi2At(next) : chi2_;
  const double fall = chi2_ - tried;
  adaptRadius((next - x_).norm(), fall, predicted);
  if (!(fall > 0)) return false;
  last_fall_ = fall;
  length_ = (next - x_).norm();
  x_ = next;
  chi2_ = tried;
  is_linear_ = is_linear;
  if (is_linear) r_.swap(next_r_), jacobian_.swap(next_jacobian_);
  return true;
}

/// Takes a step; as long as chi2 does not decrease, tries again with a shorter step.
TrustRegionMinimizer::Step TrustRegionMinimizer::step(double tolerance) {
  for (bool is_first = true;; is_first = false) {
    double damping = 0;
    const VectorXd next = scaled_.withinBounds(x_ + boundedStep(scaled_, model_, x_, free_, radius_, damping));
    const double predicted = model_.predictedReduction(next - x_);
    const double little = tolerance * std::max(chi2_, kNoLackOfFit);
    // A damped step may gain little merely because it is short. It indicates convergence only if the previous step also
    // gained little.
    if (std::abs(predicted) <= little && (damping == 0 || (is_first && last_fall_ <= little))) return Step::kAtRest;
    if (moveTo(next, predicted, is_first)) {
      damping_ = damping;
      return Step::kTaken;
    }
    if (radius_ <= kLeastRadius * size_) return Step::kOnlyRounding;
  }
}

LeastSquaresResult TrustRegionMinimizer::run(const LeastSquaresStop& stop) {
  using Status = LeastSquaresStatus;
  if (!scaled_.linearizeAt(x_, r_, jacobian_)) return scaled_.failureAtStart();
  for (;; ++iterations_) {
    chi2_ = r_.squaredNorm();
    if (observe_) observe_({"levenberg-marquardt", iterations_, chi2_, length_, damping_});
    model_.open(jacobian_, r_);
    free_ = movable(scaled_, x_, model_.gradient);
    if (!model_.gradient.allFinite() || !model_.normal.allFinite())
      return end(Status::kFailed, "the derivatives are too large to be squared");
    if (free_.empty()) return end(Status::kConverged, "every variable is at a bound");
    if (model_.gradient(free_).isZero(0)) return end(Status::kConverged, "chi2 does not depend on the variables here");
    if (iterations_ == stop.max_iterations) return end(Status::kIterationLimit, "stopped at the iteration limit");
    const Step taken = step(stop.tolerance);
    if (taken == Step::kAtRest) return end(Status::kConverged, "no step would lower chi2 by more than the tolerance");
    if (taken == Step::kOnlyRounding) return end(Status::kConverged, "chi2 falls only within rounding");
    if (!is_linear_ && !scaled_.linearizeAt(x_, r_, jacobian_))
      return end(Status::kFailed, "the model could not be differentiated");
  }
}

}  // namespace

LeastSquaresResult minimizeByLevenbergMarquardt(const LeastSquaresProblem& problem, const LeastSquaresStop& stop,
                                                const IterationObserver& observe) {
  return TrustRegionMinimizer(problem, observe).run(stop);
}

}  // namespace tubeplan::calibration
