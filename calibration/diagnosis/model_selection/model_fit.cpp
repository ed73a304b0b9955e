#include "calibration/diagnosis/model_selection/model_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "calibration/diagnosis/model_selection/model_evidence.hpp"
#include "calibration/diagnosis/model_selection/noise_hypotheses.hpp"
#include "calibration/diagnosis/model_selection/placed_model.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/prior.hpp"
#include "calibration/estimation/span.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr int kIterations = 20;
constexpr double kSmallFall = 0.03;  // decrease of chi-square in one step below which the fit ends
// Prior standard deviation of an effect's size during the fit, in units of the largest usual size.
constexpr double kFarSize = 4;
// Bound of an effect's size, in units of the largest usual size. No real machine exceeds it. Without the bound, a fit
// might shrink the arm to a point.
constexpr double kMostSize = 10;
// The most similar known effect reproduces a part of an unknown effect. Typical length of this part, relative to the
// length of the unexplained part (both in noise sigmas).
constexpr double kLikeness = 0.7;
// Logarithm of 100: the size of an independent cause may lie anywhere within two orders of magnitude.
constexpr double kOrders = 4.6;
// Probability that scatter is due to an unknown effect rather than to understated noise.
constexpr double kUnknownScatter = 0.5;
constexpr double kHardlyLeft = 1e-3;  // smallest probability of unexplained errors that is considered

/// Returns the unknowns of a model's fit, in this order: unknowns of the basis, other parameters of the effects,
/// scanned parameters.
std::vector<Unknown> unknownsOf(const DiagnosisWork& work, const PlacedModel& placed) {
  std::vector<Unknown> unknowns = work.basis.unknowns;
  for (Unknown size : placed.sizes) {
    if (size.path.effect >= 0) {
      size.prior_sigma = kFarSize * size.typical;
      size.lower = std::max(size.lower, -kMostSize * size.typical);
      size.upper = std::min(size.upper, kMostSize * size.typical);
    }
    unknowns.push_back(size);
  }
  unknowns.insert(unknowns.end(), placed.shapes.begin(), placed.shapes.end());
  return unknowns;
}

/// Returns the start values of a fit, with the effects' sizes from the linear evidence.
VectorXd startOfFit(const DiagnosisWork& work, const CompetingModel& model, const PlacedModel& placed,
                    const std::vector<Unknown>& unknowns) {
  const auto fitted = static_cast<Index>(work.basis.unknowns.size());
  VectorXd x = zerosOf(unknowns);
  for (std::size_t k = 0; k < placed.sizes.size(); ++k) {
    const Unknown& size = unknowns[static_cast<std::size_t>(fitted) + k];
    const double linear = model.sizes.size() > static_cast<Index>(k) ? model.sizes[static_cast<Index>(k)] : 0;
    x[fitted + static_cast<Index>(k)] = std::clamp(linear * size.typical, size.lower, size.upper);
  }
  return x;
}

/// Returns the fit that starts at `x`, under the noise assumption with index `by`.
LeastSquaresResult minimize(const DiagnosisWork& work, std::size_t by, const PlacedModel& placed,
                            const std::vector<Unknown>& unknowns, const VectorXd& x) {
  const NoiseHypothesis& noise = work.noise[by];
  const double tolerance = std::clamp(kSmallFall / static_cast<double>(noise.weights.rows), 1e-6, 1e-4);
  const LeastSquaresOptions solver{tolerance, kIterations, LeastSquaresMethod::kLevenbergMarquardt, work.basis.stop};
  return minimizeOrUnwind(fitProblem(placed.arm, unknowns, work.basis.measurements, noise.weights, x, work.basis.stop),
                          solver);
}

/// Returns true if the fitted size of an effect is larger than on any real machine.
bool isImpossible(const PlacedModel& placed, const VectorXd& x, std::size_t fitted) {
  for (std::size_t k = 0; k < placed.sizes.size(); ++k) {
    const Unknown& size = placed.sizes[k];
    const double most = 0.999 * kMostSize * size.typical;
    if (size.path.effect >= 0 && std::abs(x[static_cast<Index>(fitted + k)]) > most) return true;
  }
  return false;
}

/// Model linearised about its optimum, for one noise assumption.
struct AtOptimum {
  WhitenedResidual residual;
  std::unique_ptr<LinearEvidence> evidence;
  SourceView sources;
  /// Units and prior information of all parameters: fitted parameters, scanned parameters, then the effects' sizes.
  VectorXd scale, information;
};

/// Sets the inner products with the columns of single sources. Parameters are in units of Unknown::typical;
/// evidenceAt() scales the effects' sizes by their priors.
void viewSources(const MatrixXd& J, const MatrixXd& S, const VectorXd& y, const std::vector<Unknown>& others,
                 const NoiseHypothesis& noise, AtOptimum& at) {
  if (!noise.sources) return;
  const Index n = J.cols() + S.cols();
  MatrixXd W_y(y.size(), n + 1);
  W_y << J, S, y;
  at.scale = VectorXd::Ones(n);
  at.information = VectorXd::Ones(n);
  for (Index k = 0; k < J.cols(); ++k) W_y.col(n) -= J.col(k) * others[static_cast<std::size_t>(k)].prior_mean;
  at.scale.head(J.cols()) = typicalsOf(others);
  at.information.head(J.cols()) = priorInformation(others);
  at.sources = noise.sources->viewOf(W_y);
}

/// Linearises the model at `x` with the effects' sizes relative to zero, so that y is the error of the model without
/// these effects. Returns false if the model cannot be evaluated.
bool linearizeAt(const DiagnosisWork& work, const PlacedModel& placed, const std::vector<Unknown>& unknowns,
                 const VectorXd& x, const NoiseHypothesis& noise, AtOptimum& at) {
  at.residual =
      whitenedResidual(placed.arm, unknowns, work.basis.measurements, noise.weights, x, true, work.basis.stop);
  if (!at.residual.ok || !at.residual.r.allFinite() || !at.residual.jacobian.allFinite()) return false;
  const auto fitted = static_cast<Index>(work.basis.unknowns.size()), sizes = static_cast<Index>(placed.sizes.size());
  const auto shapes = static_cast<Index>(placed.shapes.size());
  MatrixXd J(at.residual.r.size(), fitted + shapes), S = at.residual.jacobian.middleCols(fitted, sizes);
  J << at.residual.jacobian.leftCols(fitted), at.residual.jacobian.rightCols(shapes);
  std::vector<Unknown> others(unknowns.begin(), unknowns.begin() + fitted);
  others.insert(others.end(), unknowns.end() - shapes, unknowns.end());
  for (Index k = 0; k < fitted; ++k) others[static_cast<std::size_t>(k)].prior_mean -= x[k];
  for (Index k = 0; k < shapes; ++k) others[static_cast<std::size_t>(fitted + k)].prior_mean -= x[fitted + sizes + k];
  VectorXd y = -at.residual.r;
  for (Index k = 0; k < sizes; ++k) {
    y += S.col(k) * x[fitted + k];
    S.col(k) *= placed.sizes[static_cast<std::size_t>(k)].typical;
  }
  EvidenceGram gram;
  gram.add(J, S, noise.discrepancy, y);
  gram.log_density = logDensityOf(noise.weights);
  at.evidence = std::make_unique<LinearEvidence>(gram, others, noise.options);
  viewSources(J, S, y, others, noise, at);
  return true;
}

std::vector<PriorSize> priorsOf(const PlacedModel& placed, double scale) {
  std::vector<PriorSize> priors;
  for (std::size_t k = 0; k < placed.sizes.size(); ++k) {
    const Unknown& size = placed.sizes[k];
    const bool is_of_effect = size.path.effect >= 0;
    priors.push_back({static_cast<int>(k), is_of_effect ? scale : size.prior_sigma / size.typical,
                      signWithin(size.lower, size.upper)});
  }
  return priors;
}

WeighedDiscrepancy evidenceAt(const AtOptimum& at, const NoiseHypothesis& noise, const std::vector<PriorSize>& sizes) {
  const Evidence evidence = at.evidence->of(sizes);
  if (!noise.sources) return {evidence, {}};
  VectorXd scale = at.scale;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    scale[scale.size() - static_cast<Index>(sizes.size() - k)] = sizes[k].sigma;
  const auto single = noise.sources->evidenceWithSource(at.sources, scale, at.information, noise.options.discrepancies,
                                                        evidence.none_scale);
  return withSources(evidence, single, noise.options);
}

/// Stores in `model` the most probable errors that the discrepancy term attributes to unknown causes.
void keepRemainder(const NoiseHypothesis& noise, const AtOptimum& at, const std::vector<PriorSize>& sizes,
                   CompetingModel& model) {
  if (model.source.source >= 0) {
    model.remainder = noise.sources->errorsOf(model.source.source, model.source.weights);
    model.remainder_terms = VectorXd::Zero(noise.principal_terms.rows());
    model.remainder_terms(noise.sources->termsOf(model.source.source)) = model.source.weights;
  } else if (model.discrepancy > 0) {
    const VectorXd weights = at.evidence->discrepancyWeights(sizes, model.discrepancy);
    model.remainder = noise.discrepancy * weights;
    model.remainder_terms = noise.principal_terms * weights;
  }
  if (model.remainder.size() > 0) model.remainder_left = partOutsideSpan(at.residual.jacobian, model.remainder);
}

/// Returns the length of the errors that the model leaves unexplained, in noise sigmas: the errors due to the
/// discrepancy, or, without a discrepancy, all errors beyond the stated noise. 0 if there are none.
double unexplainedLength(const DiagnosisWork& work, const AtOptimum& stated, std::size_t numbers,
                         const CompetingModel& model) {
  if (model.remainder.size() > 0) return model.remainder.norm();
  std::vector<int> columns(numbers);
  std::iota(columns.begin(), columns.end(), 0);
  const double expected = work.noise.front().options.noise_rows - static_cast<double>(numbers);
  return std::sqrt(std::max(0., stated.evidence->chi2() - stated.evidence->fall(columns) - expected));
}

/// Returns how much a term explains in addition to the other terms, as a length in noise sigmas: the square root of its
/// decrease of chi-square minus the decrease expected from noise.
double lengthOf(const LinearEvidence& evidence, std::size_t first, std::size_t count, std::size_t all) {
  std::vector<int> columns(all);
  std::iota(columns.begin(), columns.end(), 0);
  std::vector<int> others = columns;
  const auto from = others.begin() + static_cast<std::ptrdiff_t>(first);
  others.erase(from, from + static_cast<std::ptrdiff_t>(count));
  const double fall = evidence.fall(columns) - evidence.fall(others) - static_cast<double>(count);
  return std::sqrt(std::max(0., fall));
}

/// Returns the log ratio of two densities of a term's length: for a term that only resembles an unknown effect, and for
/// an independent cause. In the first case the density is normal about zero with the scale of the unexplained length
/// `unexplained`. In the second case it spans two orders of magnitude.
double logOddsOfLikeness(double length, double unexplained) {
  const double ratio = length / (kLikeness * unexplained);
  if (!(ratio > 0)) return -std::numeric_limits<double>::infinity();
  return 0.5 * std::log(2 / std::numbers::pi) + std::log(ratio * kOrders) - 0.5 * ratio * ratio;
}

/// Weighs, for each term of a model with a discrepancy, the hypothesis that the term only resembles an unknown effect.
/// In this case, the search has found the known effect that is most similar, with a discrepancy for the remainder. The
/// length of such a term is of the order of the discrepancy, whereas an independent cause may have any length.
void weighLikenesses(const DiagnosisWork& work, const PlacedModel& placed, const std::vector<AtOptimum>& at,
                     CompetingModel& model) {
  const double remains = model.discrepancy_probability + kUnknownScatter * model.scatter_probability;
  if (model.terms.empty() || remains < kHardlyLeft) return;
  const double unexplained = unexplainedLength(work, at.front(), placed.sizes.size(), model);
  if (!(unexplained > 0)) return;
  const bool is_of_more_noise = model.remainder.size() > 0 && model.more_noise_probability > 0.5;
  const LinearEvidence& seen = *(is_of_more_noise ? at.back() : at.front()).evidence;
  const auto count = model.terms.size();
  const double log_prior =
      logPriorOfCount(count - 1) - logPriorOfCount(count) - std::log(static_cast<double>(count)) + std::log(remains);
  std::size_t first = 0;
  for (std::size_t t = 0; t < count; first += placed.counts[t++]) {
    const double length = lengthOf(seen, first, placed.counts[t], placed.sizes.size());
    model.likenesses.push_back({t, model.logWeight() + log_prior + logOddsOfLikeness(length, unexplained)});
  }
}

/// Returns true if an effect that acts at every joint is significant at no more than one joint in the fit that ended at
/// `x`. The effect at this joint alone is then an equivalent cause.
bool saysOneOnly(const DiagnosisWork& work, const CompetingModel& model, const PlacedModel& placed, const VectorXd& x) {
  const std::size_t fitted = work.basis.unknowns.size();
  std::size_t k = 0;
  for (const ModelTerm& term : model.terms) {
    int found = 0;
    for (const std::size_t end = k + term.numbers.size(); k < end; ++k)
      found += std::abs(x[static_cast<Index>(fitted + k)]) >
               kFoundSigmas * model.sigma[static_cast<Index>(k)] * placed.sizes[k].typical;
    if (work.cause(term.cause).effects.size() > 1 && found < 2) return true;
  }
  return false;
}

/// Sets the explanation from the fit that ended at `x`; the model's evidence must already be set.
void describeFit(const DiagnosisWork& work, const PlacedModel& placed, const std::vector<Unknown>& unknowns,
                 const VectorXd& x, const std::vector<AtOptimum>& at, CompetingModel& model) {
  const std::size_t likely = likelyNoise(work, model);
  Explanation& fit = model.fit;
  fit.fitted = applied(placed.arm, unknowns, x);
  fit.chi2 = at.front().residual.r.squaredNorm();
  fit.after = errorSize(work.basis.measurements, work.basis.weights, at.front().residual.error);
  const auto numbers = static_cast<double>(placed.sizes.size() + placed.shapes.size());
  fit.p_value = chiSquareTail(fit.chi2, work.noise.front().options.noise_rows - numbers);
  // The parameters stay at their fitted values, so their standard deviations are computed with the prior of the fit.
  const VectorXd sigma = evidenceAt(at[likely], work.noise[likely], priorsOf(placed, kFarSize)).sigma;
  std::size_t first = 0;
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    describeTerm(work, model.terms[t], placed, t, sigma, first, fit);
    first += placed.counts[t];
  }
  fit.model_error = model.model_error;
  fit.remainder_probability = model.discrepancy_probability;
  fit.criterion = -2 * model.logWeight();
}

/// Fits the model from `x` for the noise assumption with index `by` and computes the evidence about this fit for all
/// noise assumptions. Returns false if the fit fails.
bool fitByNoise(const DiagnosisWork& work, std::size_t by, const PlacedModel& placed,
                const std::vector<Unknown>& unknowns, VectorXd& x, std::vector<AtOptimum>& at, CompetingModel& model) {
  const auto solution = minimize(work, by, placed, unknowns, x);
  if (solution.status == LeastSquaresStatus::kFailed || isImpossible(placed, solution.x, work.basis.unknowns.size()))
    return false;
  x = solution.x;
  for (std::size_t n = 0; n < at.size(); ++n)
    if (!linearizeAt(work, placed, unknowns, x, work.noise[n], at[n])) return false;
  const bool has_effects = std::ranges::any_of(placed.sizes, [](const Unknown& size) { return size.path.effect >= 0; });
  blendEvidence(
      work, has_effects,
      [&](const NoiseHypothesis& noise, std::size_t n, double scale) {
        return evidenceAt(at[n], noise, priorsOf(placed, scale));
      },
      model);
  return true;
}

}  // namespace

void fitModel(const DiagnosisWork& work, CompetingModel& model) {
  model.is_fitted = true;
  const double linear = model.log_evidence;
  const PlacedModel placed = placeModel(work, model);
  const std::vector<Unknown> unknowns = unknownsOf(work, placed);
  VectorXd x = startOfFit(work, model, placed, unknowns);
  std::vector<AtOptimum> at(work.noise.size());
  const auto giveUp = [&] { model.log_evidence = -std::numeric_limits<double>::infinity(); };
  // The fit may explain an error that was treated as noise before it, so the model is refitted if another noise
  // assumption becomes more probable.
  constexpr int kPasses = 2;
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::size_t by = likelyNoise(work, model);
    if (!fitByNoise(work, by, placed, unknowns, x, at, model)) return giveUp();
    if (likelyNoise(work, model) == by) break;
  }
  if (saysOneOnly(work, model, placed, x)) return giveUp();
  model.gain_by_fit = model.log_evidence - linear;
  const std::size_t likely = likelyNoise(work, model);
  keepRemainder(work.noise[likely], at[likely], priorsOf(placed, 1), model);
  weighLikenesses(work, placed, at, model);
  describeFit(work, placed, unknowns, x, at, model);
}

}  // namespace tubeplan::calibration
