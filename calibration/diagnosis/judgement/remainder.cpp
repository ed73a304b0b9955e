#include "calibration/diagnosis/judgement/remainder.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "calibration/diagnosis/explanations/explanation_model.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/prior.hpp"
#include "calibration/patterns/pattern_search.hpp"
#include "calibration/patterns/variable_words.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

/// Remaining errors of a model, and their Jacobian with respect to all fitted parameters.
struct ModelResidual {
  PlacedArm placed;
  WhitenedResidual residual;
  int freedom = 0;
};

std::optional<ModelResidual> modelResidualOf(const DiagnosisWork& work, const CompetingModel& model) {
  const FittedBasis& basis = work.basis;
  ExplanationModel fitted{basis.fitted, basis.unknowns};
  if (!model.terms.empty() && model.hasFit()) fitted = modelOf(basis, model.fit);
  ModelResidual remaining{fitted.placed, {}, 0};
  remaining.residual = whitenedResidual(fitted.placed, fitted.unknowns, basis.measurements, basis.weights,
                                        zerosOf(fitted.unknowns), true, basis.stop);
  if (!remaining.residual.ok) return std::nullopt;
  remaining.freedom =
      basis.weights.degrees_of_freedom -
      numbersDetermined(posteriorCovariance(remaining.residual.jacobian, fitted.unknowns), fitted.unknowns);
  return remaining;
}

/// Returns the variables that the model's errors follow according to a pattern search, with their fractions of
/// chi-square.
std::vector<std::pair<std::string, double>> patternsLeftBy(const DiagnosisWork& work, const CompetingModel& model) {
  const auto remaining = modelResidualOf(work, model);
  if (!remaining) return {};
  const MeasurementScene scene = observe(remaining->placed, work.basis.measurements);
  if (!scene.ok) return {};
  const PatternSearch patterns = searchPatterns(scene, work.basis.weights, remaining->residual, kPatternLevel,
                                                withoutProgress(work.options.hooks));
  std::vector<std::pair<std::string, double>> followed;
  for (const auto& finding : patterns.findings)
    if (finding.trend.size() > 1) followed.emplace_back(variableWords(finding.variable), finding.share);
  return followed;
}

/// If the first two variables account for less than half of the remainder, replaces the variables by the results of a
/// pattern search, because the remainder then consists of many small terms.
void preferPatterns(const DiagnosisWork& work, const CompetingModel& model, Remainder& remainder) {
  double first_two = 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(2, remainder.follows.size()); ++k)
    first_two += remainder.follows[k].second;
  if (first_two >= 0.5) return;
  if (auto patterns = patternsLeftBy(work, model); !patterns.empty()) remainder.follows = std::move(patterns);
}

}  // namespace

Repeats repeatsBy(const DiagnosisWork& work, const CompetingModel& model) {
  const auto remaining = modelResidualOf(work, model);
  if (!remaining) return {};
  return judgeRepeats(work.basis.measurements, work.basis.weights, remaining->residual.error,
                      remaining->residual.r.squaredNorm(), remaining->freedom);
}

SamePosture samePostureBy(const DiagnosisWork& work, const CompetingModel& model) {
  const FittedBasis& basis = work.basis;
  if (model.terms.empty() || !model.hasFit())
    return judgeSamePosture(basis.measurements, basis.weights, basis.residual.r);
  const auto residual = whitenedResidual(model.fit.fitted, {}, basis.measurements, basis.weights, {}, false);
  return residual.ok ? judgeSamePosture(basis.measurements, basis.weights, residual.r) : SamePosture{};
}

Remainder remainderOf(const DiagnosisWork& work, const CompetingModel& model) {
  Remainder remainder;
  remainder.probability = model.discrepancy_probability + model.scatter_probability;
  const double noise_floor = noiseFloor(work.basis.measurements, work.basis.weights);
  const double scatter = lengthOfRows(work.basis.measurements) * model.model_error;
  if (model.remainder.size() == 0) {  // the errors do not depend on any variable of the discrepancy
    remainder.floor = noise_floor;
    if (scatter > 0) remainder.size = scatter;
    if (const SamePosture same = samePostureBy(work, model); same.isSignificant())
      remainder.follows.emplace_back("posture", same.share);
    else
      remainder.follows = patternsLeftBy(work, model);
    return remainder;
  }
  remainder.floor = std::hypot(noise_floor, scatter);
  const NoiseHypothesis& noise = work.noise[likelyNoise(work, model)];
  double squares = 0;
  for (std::size_t k = 0; k < work.basis.measurements.size(); ++k) {
    const auto& whitener = noise.weights.whitener[k];
    const VectorXd whitened = model.remainder_left.segment(noise.weights.first_row[k], whitener.rows());
    squares += (whitener.inverse() * whitened).squaredNorm();
  }
  remainder.size = std::sqrt(squares / static_cast<double>(work.basis.measurements.size()));
  std::map<std::string, double> shares;
  double total = 0;
  for (std::size_t t = 0; t < work.discrepancy->terms().size(); ++t) {
    const auto& term = work.discrepancy->terms()[t];
    const double weight = model.remainder_terms[static_cast<Index>(t)];
    shares[term.follows] += weight * weight * term.share;
    total += weight * weight * term.share;
  }
  for (const auto& [follows, share] : shares)
    if (share > 0.05 * total) remainder.follows.emplace_back(follows, share / total);
  std::ranges::stable_sort(remainder.follows, [](const auto& a, const auto& b) { return a.second > b.second; });
  preferPatterns(work, model, remainder);
  return remainder;
}

}  // namespace tubeplan::calibration
