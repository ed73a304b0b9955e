#include "calibration/estimation/fit.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "calibration/estimation/campaign_residual.hpp"
#include "calibration/estimation/error_budget.hpp"
#include "calibration/estimation/prior.hpp"
#include "calibration/estimation/robust_loss.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

constexpr int kMaxRounds = 3;
// The fit is repeated if new weights change chi-square by more than this fraction.
constexpr double kWeightsConverged = 1e-3;
// A fit at its iteration limit is accepted as converged if the predicted decrease of chi-square is below this.
constexpr double kNearMinimum = 0.01;
constexpr int kMaxModelErrorRounds = 8;
// The fit is repeated until the model error changes by no more than this fraction.
constexpr double kModelErrorConverged = 0.01;

LeastSquaresProblem problemOf(const std::shared_ptr<CampaignResidual>& residual, const std::vector<Unknown>& unknowns,
                              const VectorXd& x) {
  const auto n = static_cast<Index>(unknowns.size());
  LeastSquaresProblem problem;
  problem.start = x;
  problem.lower.resize(n);
  problem.upper.resize(n);
  problem.scale = typicalsOf(unknowns);
  for (Index k = 0; k < n; ++k) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(k)];
    problem.lower[k] = unknown.lower;
    problem.upper[k] = unknown.upper;
  }
  problem.evaluate = [residual](const VectorXd& at, VectorXd& r, MatrixXd* jacobian) {
    return residual->evaluate(at, r, jacobian);
  };
  return problem;
}

}  // namespace

LeastSquaresProblem fitProblem(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                               const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                               const VectorXd& x, const StopQuestion& stop) {
  return problemOf(std::make_shared<CampaignResidual>(start, unknowns, measurements, weights,
                                                      CampaignResidual::Priors::kAppended, stop),
                   unknowns, x);
}

LeastSquaresResult minimizeOrUnwind(const LeastSquaresProblem& problem, const LeastSquaresOptions& solver) {
  LeastSquaresResult result = minimizeLeastSquares(problem, solver);
  if (result.status == LeastSquaresStatus::kStopped) throw WorkStopped{};
  return result;
}

namespace {

/// State of a fit while its weights and model error are iterated.
class Fitting {
 public:
  Fitting(const PlacedArm& start, const std::vector<Unknown>& unknowns, const std::vector<Measurement>& measurements,
          const VectorXd& x, const FitOptions& options)
      : start_(start),
        unknowns_(unknowns),
        measurements_(measurements),
        options_(options),
        with_priors_(std::make_shared<CampaignResidual>(start, unknowns, measurements, fit_.weights,
                                                        CampaignResidual::Priors::kAppended, options.solver.stop)) {
    fit_.solution.x = x;
    fit_.weights.model_error = options.model_error.value_or(0);
  }

  Fit run() {
    if (!untilWeightsConverge() || !describe()) return std::move(fit_);
    if (options_.model_error || !(fit_.p_value < kLackOfFit)) return std::move(fit_);
    for (int round = 0; round < kMaxModelErrorRounds; ++round) {
      const double before = fit_.weights.model_error;
      const double now = modelErrorOf(measurements_, fit_.weights, fit_.residual.error, fit_.degrees_of_freedom);
      if (std::abs(now - before) <= kModelErrorConverged * now) break;
      fit_.weights = reweighted(fit_.weights, measurements_, now, fit_.factors);
      if (!minimize() || !weigh(false) || !describe()) break;
    }
    return std::move(fit_);
  }

 private:
  bool weigh(bool is_first) {
    if (is_first && options_.weights && fit_.weights.model_error == 0) {
      fit_.weights = *options_.weights;
      return true;
    }
    const PlacedArm placed = applied(start_, unknowns_, fit_.solution.x);
    auto weights =
        weighMeasurements(placed, measurements_, fit_.factors, fit_.weights.model_error, options_.solver.stop);
    if (!weights) return failed("the model cannot be evaluated at the readings: the arm is too compliant for its load");
    fit_.weights = std::move(*weights);
    return true;
  }

  bool failed(const char* reason) {
    fit_.solution.status = LeastSquaresStatus::kFailed;
    fit_.solution.reason = reason;
    return false;
  }

  bool minimize() {
    if (unknowns_.empty()) {
      fit_.solution.status = LeastSquaresStatus::kConverged;
      return true;
    }
    const LeastSquaresResult before = fit_.solution;
    fit_.solution = minimizeOrUnwind(problemOf(with_priors_, unknowns_, before.x), options_.solver);
    countWork(before, fit_.solution);
    return fit_.solution.status != LeastSquaresStatus::kFailed;
  }

  /// Returns the residual of the measurements at the solution, with the current weights but without the priors.
  WhitenedResidual residual(bool with_jacobian) {
    WhitenedResidual at;
    at.ok = with_priors_->evaluate(fit_.solution.x, at.r, with_jacobian ? &at.jacobian : nullptr, &at.error);
    if (!at.ok) return at;
    at.r.conservativeResize(fit_.weights.rows);
    if (with_jacobian) at.jacobian.conservativeResize(fit_.weights.rows, Eigen::NoChange);
    return at;
  }

  /// Returns the chi-square of the measurements relative to their stated noise, without the model error.
  [[nodiscard]] double statedChi2() const {
    if (fit_.weights.model_error == 0)
      return comparableChi2(measurements_, fit_.weights, fit_.residual.r, options_.loss);
    const MeasurementWeights stated = reweighted(fit_.weights, measurements_, 0, fit_.factors);
    const auto by_stated =
        whitenedResidual(start_, unknowns_, measurements_, stated, fit_.solution.x, false, options_.solver.stop);
    return comparableChi2(measurements_, stated, by_stated.r, options_.loss);
  }

  /// Repeats the fit until the weights converge. The weights depend on the solution: encoder noise is propagated by the
  /// derivatives there, and robust weight factors depend on the residuals.
  bool untilWeightsConverge() {
    const bool is_robust = options_.loss != RobustLoss::kNone;
    const int rounds = is_robust ? 5 * kMaxRounds : kMaxRounds;
    double before = kNotKnown;
    for (int round = 0; round < rounds; ++round) {
      if (!weigh(round == 0)) return false;
      if (round > 0 && !is_robust) {
        const double now = residual(false).r.squaredNorm();
        if (std::abs(now - before) <= kWeightsConverged * std::max(now, 1.)) return true;
      }
      if (!minimize()) return false;
      const WhitenedResidual at = residual(false);
      if (!at.ok) return failed("the model cannot be evaluated at the readings");
      before = at.r.squaredNorm();
      if (!is_robust) continue;
      const VectorXd factors = robustFactors(measurements_, fit_.weights, at, fit_.factors, options_.loss);
      const bool is_converged = fit_.factors.size() && (factors - fit_.factors).cwiseAbs().maxCoeff() < 1e-3;
      fit_.factors = factors;
      if (is_converged) break;
    }
    return weigh(false);  // results must refer to the weights at the solution
  }

  /// Computes residual, covariance and chi-square at the solution.
  bool describe() {
    fit_.residual = residual(true);
    if (!fit_.residual.ok || !fit_.residual.r.allFinite() || !fit_.residual.jacobian.allFinite())
      return failed("the model cannot be differentiated at the readings");
    fit_.solution.chi2 = fit_.residual.r.squaredNorm();
    fit_.covariance = posteriorCovariance(fit_.residual.jacobian, unknowns_);
    fit_.degrees_of_freedom = fit_.weights.degrees_of_freedom - numbersDetermined(fit_.covariance, unknowns_);
    fit_.chi2 = statedChi2();
    fit_.p_value = chiSquareTail(fit_.chi2, fit_.degrees_of_freedom);
    if (fit_.solution.status == LeastSquaresStatus::kIterationLimit && distanceToMinimum() < kNearMinimum) {
      fit_.solution.status = LeastSquaresStatus::kConverged;
      fit_.solution.reason = "the remaining step is far below the uncertainty due to noise";
    }
    return true;
  }

  /// Returns a second-order prediction of the remaining decrease of chi-square: gradient^T covariance gradient. A value
  /// of 1 corresponds to a distance of one standard deviation.
  [[nodiscard]] double distanceToMinimum() const {
    const VectorXd gradient = fit_.residual.jacobian.transpose() * fit_.residual.r +
                              priorSlopes(unknowns_).cwiseProduct(priorResiduals(unknowns_, fit_.solution.x));
    return gradient.dot(fit_.covariance * gradient);
  }

  const PlacedArm& start_;
  const std::vector<Unknown>& unknowns_;
  const std::vector<Measurement>& measurements_;
  const FitOptions& options_;
  Fit fit_;
  std::shared_ptr<CampaignResidual> with_priors_;  ///< residual including the priors; refers to the weights in `fit_`
};

}  // namespace

Fit fitUnknowns(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                const std::vector<Measurement>& measurements, const VectorXd& x, const FitOptions& options) {
  return Fitting(start, unknowns, measurements, x, options).run();
}

ErrorSize errorSize(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                    const VectorXd& error) {
  const VectorXd lengths = errorLengths(measurements, weights, error);
  ErrorSize size;
  size.measurements = static_cast<int>(measurements.size());
  size.are_angles = measureOnlyAngles(measurements);
  if (lengths.size() == 0) return size;
  size.rms = std::sqrt(lengths.squaredNorm() / static_cast<double>(lengths.size()));
  size.mean = lengths.mean();
  size.max = lengths.maxCoeff();
  return size;
}

}  // namespace tubeplan::calibration
