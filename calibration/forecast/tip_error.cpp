#include "calibration/forecast/tip_error.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "calibration/forecast/hidden_effects.hpp"
#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr std::size_t kReferencePostures = 60;  // over which a kind's size is taken
constexpr double kTakenUp = 1e-6;               // share of a kind's square that must be left by the base
constexpr int kPasses = 4;                      // in which the range of sizes is narrowed
constexpr double kForgotten = 1e-7;             // weight of a scale that is not worth a quadrature

/// Tip slopes by the base and columns of the hidden effects at a posture.
struct Slopes {
  bool ok = false;
  Eigen::Matrix<double, 3, 6> by_base;
  Eigen::Matrix3d encoders;
  MatrixXd effects;  ///< 3 x columns; empty where they are not asked for
};

PredictionRequest byBaseAndJoints() {
  PredictionRequest request;
  request.by_base = request.by_joints = true;
  return request;
}

struct Solvers {
  std::unique_ptr<ReadingPredictor> tips;
  std::unique_ptr<HiddenEffects> hidden;
};

std::vector<Slopes> slopesAt(const TipErrorQuestion& question, const std::vector<VectorXd>& postures,
                             const std::vector<double>& loads, bool with_effects, const TipErrorOptions& options) {
  oneapi::tbb::enumerable_thread_specific<Solvers> of_thread([&] {
    return Solvers{std::make_unique<ReadingPredictor>(question.arm),
                   with_effects ? std::make_unique<HiddenEffects>(question.arm, options.difference_share) : nullptr};
  });
  const Eigen::Vector3d gravity_B = deflection::gravityInBase(question.arm, question.X_WB);
  std::vector<Slopes> slopes(postures.size());
  oneapi::tbb::parallel_for(std::size_t{0}, postures.size(), [&](std::size_t k) {
    Solvers& solvers = of_thread.local();
    const Prediction tip =
        solvers.tips->predictTip(question.X_WB, {postures[k], loads[k], gravity_B}, byBaseAndJoints());
    slopes[k].ok = tip.ok;
    if (!tip.ok) return;
    slopes[k].by_base = tip.by_base;
    slopes[k].encoders = encoderCovariance(question.arm, tip.by_joints);
    if (with_effects) slopes[k].effects = solvers.hidden->at(question.X_WB, postures[k], loads[k]);
  });
  return slopes;
}

/// Weights of the columns: each kind leaves the same mean square over the reference postures beside the best base, all
/// of them together 1 per coordinate.
VectorXd columnWeights(const std::vector<const Slopes*>& reference, const std::vector<int>& kinds) {
  const auto rows = 3 * static_cast<Index>(reference.size());
  const auto columns = static_cast<Index>(kinds.size());
  MatrixXd effects(rows, columns), base(rows, 6);
  for (std::size_t k = 0; k < reference.size(); ++k) {
    effects.middleRows(3 * static_cast<Index>(k), 3) = reference[k]->effects;
    base.middleRows(3 * static_cast<Index>(k), 3) = reference[k]->by_base;
  }
  const MatrixXd Q = Eigen::HouseholderQR<MatrixXd>(base).householderQ() * MatrixXd::Identity(rows, 6);
  const VectorXd whole = effects.colwise().squaredNorm();
  const VectorXd left = (effects - Q * (Q.transpose() * effects)).colwise().squaredNorm();
  const int count = kinds.empty() ? 0 : *std::max_element(kinds.begin(), kinds.end()) + 1;
  VectorXd of_kind = VectorXd::Zero(count), whole_of_kind = VectorXd::Zero(count);
  for (Index k = 0; k < columns; ++k) {
    of_kind[kinds[static_cast<std::size_t>(k)]] += left[k];
    whole_of_kind[kinds[static_cast<std::size_t>(k)]] += whole[k];
  }
  const auto counts = [&](int kind) { return of_kind[kind] > kTakenUp * whole_of_kind[kind] && of_kind[kind] > 0; };
  int counted = 0;
  for (int kind = 0; kind < count; ++kind) counted += counts(kind);
  VectorXd weights = VectorXd::Zero(columns);
  for (Index k = 0; k < columns; ++k) {
    const int kind = kinds[static_cast<std::size_t>(k)];
    if (counts(kind)) weights[k] = std::sqrt(static_cast<double>(rows) / (counted * of_kind[kind]));
  }
  return weights;
}

/// What the touches determine of the model's error, and through it of the tip elsewhere.
class TouchEvidence {
 public:
  TouchEvidence(const TipErrorQuestion& question, const std::vector<Slopes>& at_touches, const VectorXd& weights,
                double own_share)
      : own_share_(own_share) {
    const auto rows = 3 * static_cast<Index>(question.touches.size());
    MatrixXd A(rows, 6);
    noise_ = MatrixXd::Zero(rows, rows);
    effects_ = MatrixXd::Zero(rows, weights.size());
    VectorXd y(rows);
    ReadingPredictor tips(question.arm);
    for (std::size_t k = 0; k < question.touches.size(); ++k) {
      const Measurement& touch = question.touches[k];
      const Index row = 3 * static_cast<Index>(k);
      A.middleRows(row, 3) = at_touches[k].by_base;
      noise_.block<3, 3>(row, row) = at_touches[k].encoders + statedCovariance(touch);
      if (weights.size()) effects_.middleRows(row, 3) = at_touches[k].effects * weights.asDiagonal();
      y.segment<3>(row) =
          tips.predictTip(question.X_WB, postureOf(touch, question.arm, question.X_WB)).value - *touch.p_W;
    }
    const MatrixXd weighted = noise_.ldlt().solve(A);
    fit_ = (A.transpose() * weighted).ldlt().solve(weighted.transpose());
    const MatrixXd Q = Eigen::HouseholderQR<MatrixXd>(A).householderQ();
    left_ = Q.rightCols(rows - 6);
    observed_ = left_.transpose() * y;
    model_ = (1 - own_share_) * effects_ * effects_.transpose() + own_share_ * MatrixXd::Identity(rows, rows);
  }

  /// Of the touches' lack of fit, for a model error of that size; up to a constant.
  [[nodiscard]] double logLikelihood(double sigma) const {
    const MatrixXd S = left_.transpose() * covariance(sigma) * left_;
    const Eigen::LLT<MatrixXd> factor(S);
    const VectorXd whitened = factor.matrixL().solve(observed_);
    return -factor.matrixLLT().diagonal().array().log().sum() - whitened.squaredNorm() / 2;
  }

  [[nodiscard]] MatrixXd covariance(double sigma) const { return noise_ + sigma * sigma * model_; }

  /// The largest size that the touches can be asked about.
  [[nodiscard]] double lack_of_fit() const {
    return std::sqrt(observed_.squaredNorm() / static_cast<double>(observed_.size()));
  }
  [[nodiscard]] double noise() const { return std::sqrt(noise_.diagonal().mean()); }

  /// All that does not depend on the hole, of one size.
  struct Prepared {
    double sigma;
    MatrixXd covariance, left_inverse;  ///< of the touches; (Z^T C Z)^-1
  };
  [[nodiscard]] Prepared prepare(double sigma) const {
    Prepared prepared{sigma, covariance(sigma), {}};
    prepared.left_inverse = (left_.transpose() * prepared.covariance * left_).inverse();
    return prepared;
  }

  [[nodiscard]] TipErrorCase at(const Slopes& hole, const VectorXd& weights, const Prepared& prepared) const {
    const double variance = prepared.sigma * prepared.sigma;
    const MatrixXd base = hole.by_base.topRows(2) * fit_;  // 2 x rows
    MatrixXd with_touches = MatrixXd::Zero(2, noise_.rows());
    Eigen::Matrix2d alone = own_share_ * Eigen::Matrix2d::Identity();
    if (weights.size()) {
      const MatrixXd effects = hole.effects.topRows(2) * weights.asDiagonal();
      with_touches = (1 - own_share_) * variance * effects * effects_.transpose();
      alone += (1 - own_share_) * effects * effects.transpose();
    }
    const Eigen::Matrix2d crossed = with_touches * base.transpose();
    const MatrixXd informed = -(with_touches - base * prepared.covariance) * left_;  // covariance of e and Z^T y
    TipErrorCase tip;
    const MatrixXd gain = informed * prepared.left_inverse;
    tip.mean = gain * observed_;
    tip.covariance = variance * alone + hole.encoders.topLeftCorner<2, 2>() +
                     base * prepared.covariance * base.transpose() - crossed - crossed.transpose() -
                     gain * informed.transpose();
    tip.covariance = (tip.covariance + tip.covariance.transpose().eval()) / 2;
    return tip;
  }

 private:
  double own_share_;
  MatrixXd noise_, effects_, model_;
  MatrixXd fit_;       ///< G: 6 x rows
  MatrixXd left_;      ///< Z
  VectorXd observed_;  ///< Z^T y
};

/// Sizes of the model's error and their probabilities.
struct Scales {
  std::vector<double> sigma, weight;
};

void forgetUnlikely(Scales& scales) {
  double sum = 0;
  for (const double weight : scales.weight) sum += weight;
  Scales kept;
  for (std::size_t k = 0; k < scales.sigma.size(); ++k) {
    if (!(scales.weight[k] > kForgotten * sum)) continue;
    kept.sigma.push_back(scales.sigma[k]);
    kept.weight.push_back(scales.weight[k]);
  }
  sum = 0;
  for (const double weight : kept.weight) sum += weight;
  for (double& weight : kept.weight) weight /= sum;
  scales = kept;
}

/// Logarithm of the prior density of log(sigma), up to a constant.
double logPrior(double sigma, const TipErrorQuestion& question, const TipErrorOptions& options) {
  if (!question.stated) {
    const double ratio = sigma / options.usual_error;
    return std::log(ratio) - std::log1p(ratio * ratio);
  }
  const double freedom = question.stated->degrees_of_freedom, ratio = question.stated->sigma / sigma;
  return freedom * std::log(ratio) - freedom * ratio * ratio / 2;
}

/// Sizes evenly spread by their logarithm, and their weights.
template <class LogDensity>
Scales lookAt(double least, double most, const LogDensity& log_density, int count) {
  Scales scales;
  std::vector<double> logs;
  for (int k = 0; k < count; ++k) {
    scales.sigma.push_back(least * std::pow(most / least, static_cast<double>(k) / (count - 1)));
    logs.push_back(log_density(scales.sigma.back()));
  }
  const double best = *std::max_element(logs.begin(), logs.end());
  for (const double log : logs) scales.weight.push_back(std::exp(log - best));
  forgetUnlikely(scales);
  return scales;
}

Scales scalesFor(const TipErrorQuestion& question, const TouchEvidence* touches, const TipErrorOptions& options) {
  if (question.stated && (question.stated->degrees_of_freedom == 0 || question.stated->sigma == 0))
    return {{question.stated->sigma}, {1}};
  const double size = question.stated ? question.stated->sigma : options.usual_error;
  double least = std::min(size, touches ? touches->noise() : size) / 30;
  double most = std::max(size, touches ? touches->lack_of_fit() : size) * 100;
  // Looked at coarsely, then where it is likely: many degrees of freedom leave a narrow range of sizes.
  const auto logPosterior = [&](double sigma) {
    return logPrior(sigma, question, options) + (touches ? touches->logLikelihood(sigma) : 0);
  };
  Scales scales = lookAt(least, most, logPosterior, options.scales);
  for (int pass = 0; pass < kPasses; ++pass) {
    const double step = std::pow(most / least, 1. / (options.scales - 1));
    const double from = std::max(least, scales.sigma.front() / step), to = std::min(most, scales.sigma.back() * step);
    if (to / from > 0.5 * (most / least)) break;
    least = from;
    most = to;
    scales = lookAt(least, most, logPosterior, options.scales);
  }
  return scales;
}

double quantileOf(const Scales& scales, double share) {
  double sum = 0;
  for (std::size_t k = 0; k < scales.sigma.size(); ++k)
    if ((sum += scales.weight[k]) >= share) return scales.sigma[k];
  return scales.sigma.back();
}

void describeScales(const Scales& scales, TipError& error) {
  error.model_error = quantileOf(scales, 0.5);
  error.lower = quantileOf(scales, 0.025);
  error.upper = quantileOf(scales, 0.975);
}

/// Some of the postures, spread over the list, and all touches.
std::vector<const Slopes*> referenceSlopes(const std::vector<Slopes>& at_touches, const std::vector<Slopes>& at) {
  std::vector<const Slopes*> reference;
  const auto add = [&](const Slopes& slopes) {
    if (slopes.ok) reference.push_back(&slopes);
  };
  for (const auto& slopes : at_touches) add(slopes);
  const std::size_t count = std::min(kReferencePostures, at.size());
  for (std::size_t k = 0; k < count; ++k) add(at[k * at.size() / count]);
  return reference;
}

TipError byTouches(const TipErrorQuestion& question, const TipErrorOptions& options) {
  TipError error;
  error.source = question.stated ? ModelErrorSource::kStated : ModelErrorSource::kTouches;
  const bool with_effects = !question.stated;
  std::vector<VectorXd> touched;
  std::vector<double> touch_loads;
  for (const auto& touch : question.touches) {
    touched.push_back(touch.q);
    touch_loads.push_back(touch.load);
  }
  const auto at_touches = slopesAt(question, touched, touch_loads, with_effects, options);
  const auto at = slopesAt(question, question.postures, std::vector<double>(question.postures.size(), question.load),
                           with_effects, options);
  VectorXd weights;
  if (with_effects)
    weights =
        columnWeights(referenceSlopes(at_touches, at), HiddenEffects(question.arm, options.difference_share).kinds());
  const TouchEvidence evidence(question, at_touches, weights, with_effects ? options.own_share : 1);
  const Scales scales = scalesFor(question, &evidence, options);
  describeScales(scales, error);
  std::vector<TouchEvidence::Prepared> prepared;
  for (const double sigma : scales.sigma) prepared.push_back(evidence.prepare(sigma));
  error.at.resize(at.size());
  oneapi::tbb::parallel_for(std::size_t{0}, at.size(), [&](std::size_t k) {
    if (!at[k].ok) return;
    for (std::size_t s = 0; s < prepared.size(); ++s) {
      error.at[k].push_back(evidence.at(at[k], weights, prepared[s]));
      error.at[k].back().weight = scales.weight[s];
    }
  });
  return error;
}

TipError byCovariance(const TipErrorQuestion& question, const TipErrorOptions& options) {
  TipError error;
  Scales scales{{0}, {1}};
  if (question.stated) {
    error.source = ModelErrorSource::kStated;
    scales = scalesFor(question, nullptr, options);
    describeScales(scales, error);
  }
  const auto at = slopesAt(question, question.postures, std::vector<double>(question.postures.size(), question.load),
                           false, options);
  error.at.resize(at.size());
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (!at[k].ok) continue;
    const Eigen::Matrix3d base = at[k].by_base * question.base_covariance * at[k].by_base.transpose();
    const Eigen::Matrix2d known = (base + at[k].encoders).topLeftCorner<2, 2>();
    for (std::size_t s = 0; s < scales.sigma.size(); ++s)
      error.at[k].push_back({scales.weight[s], Eigen::Vector2d::Zero(),
                             known + scales.sigma[s] * scales.sigma[s] * Eigen::Matrix2d::Identity()});
  }
  return error;
}

}  // namespace

TipError findTipError(const TipErrorQuestion& question, const TipErrorOptions& options) {
  constexpr std::size_t kLeastTouches = 3;
  return question.touches.size() < kLeastTouches ? byCovariance(question, options) : byTouches(question, options);
}

}  // namespace tubeplan::calibration
