#include "calibration/diagnosis/discrimination/rival_prediction.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "calibration/estimation/prior.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// Returns the covariance of the unknowns given the measurements and priors; given the priors alone if the model cannot
/// be evaluated.
MatrixXd covarianceOf(const FittedBasis& basis, const ExplanationModel& model) {
  const auto residual =
      whitenedResidual(model.placed, model.unknowns, basis.measurements, basis.weights, zerosOf(model.unknowns), true);
  return posteriorCovariance(residual.ok ? residual.jacobian : MatrixXd(), model.unknowns);
}

/// Returns the expected measurements of a candidate in the last set-up; empty if the arm's shape does not converge.
/// Touches of an unknown point get a separate point name for each candidate. Any rival's arm can be used, because only
/// differences between predictions matter.
std::vector<Measurement> measurementsOf(const MeasurementCandidate& candidate, std::size_t index,
                                        const PlacedArm& placed) {
  std::vector<Measurement> measurements;
  for (const auto& proposed : candidate.measurements) {
    auto measurement = expectedMeasurement(placed, proposed);
    if (!measurement) return {};
    if (touchesUnknownPoint(proposed)) measurement->point = "candidate " + std::to_string(index);
    measurements.push_back(std::move(*measurement));
  }
  return measurements;
}

RivalPrediction predictByAll(const std::vector<RivalModel>& rivals, const std::vector<Measurement>& measurements,
                             const StopQuestion& stop) {
  RivalPrediction all;
  const auto weights = weighMeasurements(rivals.front().model.placed, measurements);
  if (!weights) return all;
  for (const RivalModel& rival : rivals) {
    throwIfStopped(stop);
    auto residual = whitenedResidual(rival.model.placed, rival.model.unknowns, measurements, *weights,
                                     zerosOf(rival.model.unknowns), true);
    if (!residual.ok) return {};
    all.value.push_back(std::move(residual.r));
    all.sensitivity.push_back(std::move(residual.jacobian));
  }
  return all;
}

/// Returns `count` rows of the predictions, starting at row `first`.
RivalPrediction someRows(const RivalPrediction& all, Index first, Index count) {
  RivalPrediction part;
  for (std::size_t m = 0; m < all.value.size(); ++m) {
    part.value.emplace_back(all.value[m].segment(first, count));
    part.sensitivity.emplace_back(all.sensitivity[m].middleRows(first, count));
  }
  return part;
}

double logDeterminant(const Eigen::LDLT<MatrixXd>& factors) { return factors.vectorD().array().log().sum(); }

/// Returns the expected rise due to measured values that rival a predicts with covariance S_a and rival b with S_b; d
/// is the difference between their mean predictions.
ExpectedRise riseBetween(const MatrixXd& S_a, const MatrixXd& S_b, const VectorXd& d) {
  const Eigen::LDLT<MatrixXd> a(S_a), b(S_b);
  const MatrixXd excess = b.solve(S_a) - MatrixXd::Identity(d.size(), d.size());
  const VectorXd whitened = b.solve(d);
  return {d.dot(whitened) + excess.trace() + logDeterminant(b) - logDeterminant(a),
          std::sqrt(2 * (excess * excess).trace() + 4 * std::max(0., whitened.dot(S_a * whitened)))};
}

/// State of the greedy choice, updated as measurements are chosen: covariances of the rivals' parameters, and the mean
/// shifts of these parameters if another rival is true.
class Race {
 public:
  Race(const std::vector<RivalModel>& rivals, const std::vector<RivalPrediction>& predictions)
      : rivals_(rivals), predictions_(predictions) {
    const std::size_t n = rivals.size();
    probability_ = probabilitiesOf(rivals);
    for (const RivalModel& rival : rivals) covariance_.push_back(rival.covariance);
    moved_.resize(n, std::vector<VectorXd>(n));
    rise_.resize(n, std::vector<double>(n, 0));
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) {
        moved_[a][b] = VectorXd::Zero(covariance_[b].rows());
        rise_[a][b] = rivals[b].criterion - rivals[a].criterion;
      }
  }

  /// Returns the expected odds of the wrong rivals after this candidate is measured, estimated from their expected log
  /// odds. Averages over which rival is true, weighted by probability; a smaller score is better.
  [[nodiscard]] double scoreWith(std::size_t candidate) const {
    double score = 0;
    forPairs(candidate, [&](std::size_t a, std::size_t b, double rise) {
      score += probability_[a] * std::exp(-(rise_[a][b] + rise) / 2);
    });
    return score;
  }

  [[nodiscard]] DiscriminatingMeasurement describe(std::size_t candidate) const {
    DiscriminatingMeasurement step;
    step.candidate = static_cast<int>(candidate);
    double most = -1;
    forPairs(candidate, [&](std::size_t a, std::size_t b, double rise) {
      // Either rival may be true, so the smaller rise measures how well the pair is separated.
      const double both = std::min(rise, riseOf(candidate, b, a));
      if (both <= most) return;
      most = both;
      step.a = static_cast<int>(std::min(a, b));
      step.b = static_cast<int>(std::max(a, b));
      step.separation = std::sqrt(both);
    });
    return step;
  }

  void take(std::size_t candidate) {
    forPairs(candidate, [&](std::size_t a, std::size_t b, double rise) { rise_[a][b] += rise; });
    const RivalPrediction& at = predictions_[candidate];
    for (std::size_t b = 0; b < rivals_.size(); ++b) {
      const MatrixXd& H = at.sensitivity[b];
      const MatrixXd PHt = covariance_[b] * H.transpose();
      const Eigen::LDLT<MatrixXd> S(MatrixXd::Identity(H.rows(), H.rows()) + H * PHt);
      for (std::size_t a = 0; a < rivals_.size(); ++a)
        if (a != b) moved_[a][b] += PHt * S.solve(at.value[a] - at.value[b] - H * moved_[a][b]);
      covariance_[b] -= PHt * S.solve(PHt.transpose());
    }
  }

 private:
  [[nodiscard]] MatrixXd predictedCovariance(std::size_t candidate, std::size_t rival) const {
    const MatrixXd& H = predictions_[candidate].sensitivity[rival];
    return MatrixXd::Identity(H.rows(), H.rows()) + H * covariance_[rival] * H.transpose();
  }

  [[nodiscard]] double riseOf(std::size_t candidate, std::size_t a, std::size_t b) const {
    const RivalPrediction& at = predictions_[candidate];
    return riseBetween(predictedCovariance(candidate, a), predictedCovariance(candidate, b),
                       at.value[a] - at.value[b] - at.sensitivity[b] * moved_[a][b])
        .mean;
  }

  template <class Use>
  void forPairs(std::size_t candidate, Use use) const {
    for (std::size_t a = 0; a < rivals_.size(); ++a)
      for (std::size_t b = 0; b < rivals_.size(); ++b)
        if (a != b) use(a, b, riseOf(candidate, a, b));
  }

  const std::vector<RivalModel>& rivals_;
  const std::vector<RivalPrediction>& predictions_;
  std::vector<double> probability_;
  std::vector<MatrixXd> covariance_;
  std::vector<std::vector<VectorXd>> moved_;  ///< mean shift of a rival's parameters, indexed [truth][rival]
  std::vector<std::vector<double>> rise_;     ///< expected rise of -2 log of the posterior, indexed [truth][rival]
};

}  // namespace

std::vector<RivalModel> rivalModelsOf(const FittedBasis& basis, const std::vector<Explanation>& explanations) {
  std::vector<RivalModel> rivals;
  for (const auto& explanation : explanations) {
    RivalModel rival{modelOf(basis, explanation), explanation.criterion, {}};
    rival.covariance = covarianceOf(basis, rival.model);
    rivals.push_back(std::move(rival));
  }
  return rivals;
}

std::vector<double> probabilitiesOf(const std::vector<RivalModel>& rivals) {
  std::vector<double> logs;
  for (const RivalModel& rival : rivals) logs.push_back(-rival.criterion / 2);
  return probabilitiesOf(logs);
}

std::vector<RivalPrediction> predictByRivals(const std::vector<RivalModel>& rivals,
                                             const std::vector<MeasurementCandidate>& candidates,
                                             const StopQuestion& stop) {
  std::vector<std::vector<Measurement>> each(candidates.size());
  std::vector<Measurement> all;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    throwIfStopped(stop);
    each[k] = measurementsOf(candidates[k], k, rivals.front().model.placed);
    all.insert(all.end(), each[k].begin(), each[k].end());
  }
  std::vector<RivalPrediction> predictions(candidates.size());
  if (all.empty()) return predictions;
  const RivalPrediction together = predictByAll(rivals, all, stop);
  Index first = 0;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (each[k].empty()) continue;
    Index rows = 0;
    for (const auto& measurement : each[k]) rows += rowsOf(measurement);
    // Displacements from the same reference measurement share its encoder noise. They are predicted separately, because
    // whitening them jointly would mix the candidates.
    const bool is_only_answer = together.value.empty() || referenceOf(each[k].front());
    predictions[k] = is_only_answer ? predictByAll(rivals, each[k], stop) : someRows(together, first, rows);
    first += rows;
  }
  return predictions;
}

std::vector<DiscriminatingMeasurement> chooseDiscriminating(const std::vector<RivalModel>& rivals,
                                                            const std::vector<RivalPrediction>& predictions, int count,
                                                            const StopQuestion& stop) {
  Race race(rivals, predictions);
  std::vector<bool> is_taken(predictions.size());
  std::vector<DiscriminatingMeasurement> steps;
  while (static_cast<int>(steps.size()) < count) {
    std::size_t best = predictions.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < predictions.size(); ++k) {
      if (is_taken[k] || predictions[k].value.empty()) continue;
      throwIfStopped(stop);
      if (const double score = race.scoreWith(k); score < least) least = score, best = k;
    }
    if (best == predictions.size()) break;
    steps.push_back(race.describe(best));
    race.take(best);
    is_taken[best] = true;
  }
  return steps;
}

ExpectedRise expectedRise(const std::vector<RivalModel>& rivals, const std::vector<RivalPrediction>& predictions,
                          const std::vector<DiscriminatingMeasurement>& steps, int a, int b, int times) {
  const auto first = static_cast<std::size_t>(a), second = static_cast<std::size_t>(b);
  Index rows = 0;
  for (const auto& step : steps) rows += predictions[static_cast<std::size_t>(step.candidate)].value[first].size();
  VectorXd d(rows * times);
  MatrixXd H_a(rows * times, rivals[first].covariance.rows()), H_b(rows * times, rivals[second].covariance.rows());
  Index at = 0;
  for (int time = 0; time < times; ++time)
    for (const auto& step : steps) {
      const RivalPrediction& prediction = predictions[static_cast<std::size_t>(step.candidate)];
      const Index n = prediction.value[first].size();
      d.segment(at, n) = prediction.value[first] - prediction.value[second];
      H_a.middleRows(at, n) = prediction.sensitivity[first];
      H_b.middleRows(at, n) = prediction.sensitivity[second];
      at += n;
    }
  const MatrixXd identity = MatrixXd::Identity(d.size(), d.size());
  return riseBetween(identity + H_a * rivals[first].covariance * H_a.transpose(),
                     identity + H_b * rivals[second].covariance * H_b.transpose(), d);
}

double leastExpected(const std::vector<RivalModel>& rivals, const std::vector<RivalPrediction>& predictions,
                     const std::vector<DiscriminatingMeasurement>& steps) {
  double least = std::numeric_limits<double>::infinity();
  for (int a = 0; a < static_cast<int>(rivals.size()); ++a)
    for (int b = 0; b < static_cast<int>(rivals.size()); ++b) {
      if (a == b) continue;
      const double now = rivals[static_cast<std::size_t>(b)].criterion - rivals[static_cast<std::size_t>(a)].criterion;
      least = std::min(least, now + (steps.empty() ? 0 : expectedRise(rivals, predictions, steps, a, b, 1).mean));
    }
  return least;
}

}  // namespace tubeplan::calibration
