#include "calibration/measurement_checks/robust_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "calibration/estimation/campaign_residual.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/prior.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kBest = 0.9;  // fraction of the measurements, with the smallest errors, that RobustFit::error includes
constexpr int kScaleSteps = 40;
constexpr double kLeastMeaningfulFreedom = 12;  // smallest number of degrees of freedom for a meaningful chi-square
constexpr double kConverged = 0.05;             // the fit ends if a step decreases the lack of fit by less than this
// Maximum number of attempts at a step; each one is shorter than the previous one.
constexpr int kMostTrials = 6;

/// Returns the sum of the smallest values, up to the fraction `share` of all values, and the number of summed values.
std::pair<double, std::size_t> sumOfLeast(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const auto kept = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  double sum = 0;
  for (std::size_t k = 0; k < kept; ++k) sum += values[k];
  return {sum, kept};
}

/// Likelihood of the whitened residuals under Student's t distribution with a common scale.
class StudentLoss {
 public:
  StudentLoss(const std::vector<Measurement>& measurements, const MeasurementWeights& weights)
      : measurements_(measurements), weights_(weights), square_(measurements.size()), weight_(measurements.size()) {}

  /// Finds and stores the most likely scale, with the weights that belong to it; returns the negative log likelihood.
  double settle(const VectorXd& r) {
    for (std::size_t k = 0; k < square_.size(); ++k)
      square_[k] = r.segment(weights_.first_row[k], rowsOf(measurements_[k])).squaredNorm();
    variance_ = std::max(1., median(square_) / 3);
    for (int step = 0; step < kScaleSteps; ++step) {
      const double before = variance_;
      double sum = 0;
      int rows = 0;
      for (std::size_t k = 0; k < square_.size(); ++k) {
        const int d = rowsOf(measurements_[k]);
        weight_[k] = studentWeight(square_[k], d, variance_);
        sum += weight_[k] * square_[k];
        rows += d;
      }
      variance_ = std::max(1., sum / rows);
      if (std::abs(variance_ - before) < 1e-3 * variance_) break;
    }
    double value = 0;
    for (std::size_t k = 0; k < square_.size(); ++k) {
      const int d = rowsOf(measurements_[k]);
      value += d * std::log(variance_) / 2 +
               (kStudentFreedom + d) / 2 * std::log1p(square_[k] / (kStudentFreedom * variance_));
    }
    return value;
  }

  /// Returns, for each row, the square root of its weight divided by the scale.
  [[nodiscard]] VectorXd rowWeights() const {
    VectorXd rows(weights_.rows);
    for (std::size_t k = 0; k < weight_.size(); ++k)
      rows.segment(weights_.first_row[k], rowsOf(measurements_[k])).setConstant(std::sqrt(weight_[k] / variance_));
    return rows;
  }

  /// Returns chi-square of the measurements with the smallest errors, divided by its expectation. `degrees_of_freedom`
  /// is for all measurements.
  [[nodiscard]] double chi2PerFreedom(double degrees_of_freedom) const {
    // If noise is normal, the worst tenth of measurements with three rows contributes a quarter of the chi-square.
    constexpr double kShareOfBest = 0.74;
    return sumOfLeast(square_, kBest).first / (degrees_of_freedom * kShareOfBest);
  }

 private:
  const std::vector<Measurement>& measurements_;
  const MeasurementWeights& weights_;
  std::vector<double> square_, weight_;
  double variance_ = 1;
};

double bestError(const VectorXd& lengths, double share) {
  const VectorXd squares = lengths.cwiseAbs2();
  const auto [sum, kept] = sumOfLeast({squares.begin(), squares.end()}, share);
  return std::sqrt(sum / static_cast<double>(kept));
}

double priorLackOfFit(const std::vector<Unknown>& unknowns, const VectorXd& x) {
  return priorResiduals(unknowns, x).squaredNorm() / 2;
}

/// Damped Gauss-Newton iteration within the bounds of the unknowns.
class Descent {
 public:
  Descent(const PlacedArm& start, const std::vector<Unknown>& unknowns, const std::vector<Measurement>& measurements,
          const MeasurementWeights& weights, const RobustFitOptions& options)
      : unknowns_(unknowns),
        options_(options),
        residual_(start, unknowns, measurements, weights, CampaignResidual::Priors::kNone, options.stop),
        loss_(measurements, weights),
        x_(zerosOf(unknowns)) {}

  bool run() {
    if (!residual_.evaluate(x_, r_, nullptr) || !r_.allFinite()) return false;
    lack_of_fit_ = loss_.settle(r_) + priorLackOfFit(unknowns_, x_);
    for (int step = 0; step < options_.most_steps && !unknowns_.empty(); ++step) {
      throwIfStopped(options_.stop);
      const double before = lack_of_fit_;
      if (!residual_.evaluate(x_, r_, &jacobian_) || !jacobian_.allFinite()) break;
      if (!improve() || before - lack_of_fit_ < kConverged) break;
    }
    return true;
  }

  [[nodiscard]] const VectorXd& x() const { return x_; }
  [[nodiscard]] double lack_of_fit() const { return lack_of_fit_; }
  StudentLoss& loss() { return loss_; }
  [[nodiscard]] const VectorXd& residual() const { return r_; }

 private:
  /// Returns the step s that minimises g^T s + s^T A s / 2 with every unknown within its bounds. An unknown that would
  /// exceed a bound is held there, and the other unknowns are solved again.
  [[nodiscard]] VectorXd boundedStep(const MatrixXd& A, const VectorXd& g) const {
    VectorXd step = VectorXd::Zero(g.size());
    std::vector<Index> free(static_cast<std::size_t>(g.size())), inside;
    std::iota(free.begin(), free.end(), Index{0});
    while (!free.empty()) {
      VectorXd held = step;
      held(free).setZero();
      const VectorXd slope = g + A * held;
      const VectorXd best = MatrixXd(A(free, free)).ldlt().solve(VectorXd(-slope(free)));
      step(free) = best;
      inside.clear();
      for (const Index k : free) {
        const Unknown& unknown = unknowns_[static_cast<std::size_t>(k)];
        const double bounded = std::clamp(x_[k] + step[k], unknown.lower, unknown.upper) - x_[k];
        if (bounded == step[k] || std::isnan(step[k]))
          inside.push_back(k);
        else
          step[k] = bounded;
      }
      if (inside.size() == free.size()) break;
      free = inside;
    }
    return step;
  }

  bool improve() {
    const VectorXd roots = loss_.rowWeights();
    const MatrixXd J = roots.asDiagonal() * jacobian_;
    const VectorXd slopes = priorSlopes(unknowns_);
    MatrixXd A = J.transpose() * J;
    A.diagonal() += slopes.cwiseAbs2();
    const VectorXd g = J.transpose() * roots.cwiseProduct(r_) + slopes.cwiseProduct(priorResiduals(unknowns_, x_));
    for (int trial = 0; trial < kMostTrials; ++trial, damping_ = std::max(4 * damping_, 1e-4)) {
      MatrixXd damped = A;
      for (Index k = 0; k < A.rows(); ++k) {
        const double typical = unknowns_[static_cast<std::size_t>(k)].typical;
        damped(k, k) += damping_ * A(k, k) + 1e-12 / (typical * typical);
      }
      VectorXd x = x_ + boundedStep(damped, g), r;
      if (!x.allFinite()) continue;
      if (!residual_.evaluate(x, r, nullptr) || !r.allFinite()) continue;
      const double lack_of_fit = loss_.settle(r) + priorLackOfFit(unknowns_, x);
      if (!(lack_of_fit < lack_of_fit_)) continue;
      x_ = x, r_ = r, lack_of_fit_ = lack_of_fit, damping_ /= 10;
      return true;
    }
    (void)loss_.settle(r_);
    return false;
  }

  const std::vector<Unknown>& unknowns_;
  const RobustFitOptions& options_;
  CampaignResidual residual_;
  StudentLoss loss_;
  VectorXd x_, r_;
  MatrixXd jacobian_;
  double lack_of_fit_ = std::numeric_limits<double>::infinity(), damping_ = 0;
};

}  // namespace

RobustFit fitRobustly(PlacedArm start, const std::vector<Measurement>& measurements, const RobustFitOptions& options) {
  RobustFit fit;
  if (measurements.empty()) return fit;
  alignBases(start, measurements);
  auto unknowns = chooseUnknowns(start, options.free);
  const auto weights = weighMeasurements(start, measurements, {}, 0, options.stop);
  if (!weights) return fit;
  Descent descent(start, unknowns.list, measurements, *weights, options);
  if (!descent.run()) return fit;
  fit.placed = applied(start, unknowns.list, descent.x());
  const auto at =
      whitenedResidual(start, unknowns.list, measurements, *weights, descent.x(), options.judges_noise, options.stop);
  if (!at.ok) return fit;
  fit.lack_of_fit = descent.lack_of_fit();
  const VectorXd lengths = errorLengths(measurements, *weights, at.error);
  fit.error = bestError(lengths, kBest);
  fit.whole_error = bestError(lengths, 1);
  if (options.judges_noise) {
    const auto covariance = posteriorCovariance(at.jacobian, unknowns.list);
    const double freedom = weights->degrees_of_freedom - effectiveNumbers(covariance, unknowns.list);
    if (freedom >= kLeastMeaningfulFreedom) fit.chi2_per_freedom = descent.loss().chi2PerFreedom(freedom);
  }
  fit.ok = std::isfinite(fit.error) && std::isfinite(fit.lack_of_fit);
  return fit;
}

}  // namespace tubeplan::calibration
