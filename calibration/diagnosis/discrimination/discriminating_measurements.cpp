#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "calibration/diagnosis/discrimination/alternative_measurements.hpp"
#include "calibration/diagnosis/discrimination/rival_prediction.hpp"
#include "calibration/estimation/set_aside.hpp"

namespace tubeplan::calibration {

namespace {

/// Rivals, their predictions at every candidate, and the chosen candidates.
struct RivalForecast {
  const std::vector<RivalModel>& rivals;
  const std::vector<RivalPrediction>& predictions;
  const std::vector<DiscriminatingMeasurement>& steps;
};

Explanation nothingMissing(const Diagnosis& diagnosis) {
  Explanation nothing;
  nothing.fitted = diagnosis.baseline.fitted;
  nothing.chi2 = diagnosis.chi2;
  nothing.criterion = diagnosis.nothing_criterion;
  return nothing;
}

/// Returns the standard normal distribution function.
double below(double x) { return std::erfc(-x / std::numbers::sqrt2) / 2; }

/// Returns the expected outcome for an ordered pair of rivals once each chosen measurement has been measured `times`
/// times.
DiscriminatedPair pairAfter(const RivalForecast& forecast, int truth, int other, int times, double gap) {
  const ExpectedRise rise = expectedRise(forecast.rivals, forecast.predictions, forecast.steps, truth, other, times);
  DiscriminatedPair pair{truth, other,
                         forecast.rivals[static_cast<std::size_t>(other)].criterion -
                             forecast.rivals[static_cast<std::size_t>(truth)].criterion};
  pair.expected = pair.now + rise.mean;
  pair.probability = below((pair.expected - gap) / std::max(1e-9, rise.sigma));
  return pair;
}

std::vector<DiscriminatedPair> pairsOf(const RivalForecast& forecast, int times, double gap) {
  std::vector<DiscriminatedPair> pairs;
  const int count = static_cast<int>(forecast.rivals.size());
  for (int a = 0; a < count; ++a)
    for (int b = 0; b < count; ++b)
      if (a != b) pairs.push_back(pairAfter(forecast, a, b, times, gap));
  return pairs;
}

/// Returns the probability that only the true explanation is named, averaged over the explanations and weighted by
/// their current probabilities.
double chanceOfNaming(const std::vector<double>& probability, const std::vector<DiscriminatedPair>& pairs) {
  double named = 0;
  for (std::size_t a = 0; a < probability.size(); ++a) {
    double chance = 1;
    for (const auto& pair : pairs)
      if (pair.truth == static_cast<int>(a)) chance = std::min(chance, pair.probability);
    named += probability[a] * chance;
  }
  return named;
}

bool isSame(const DiscriminatedPair& a, const DiscriminatedPair& b) {
  return std::minmax(a.truth, a.other) == std::minmax(b.truth, b.other);
}

/// Returns the pairs that will probably remain undecided, each listed once.
std::vector<DiscriminatedPair> unlikelyPairs(const std::vector<double>& probability,
                                             const std::vector<DiscriminatedPair>& pairs) {
  std::vector<DiscriminatedPair> unlikely;
  for (const auto& pair : pairs) {
    if (pair.truth > pair.other) continue;
    double named = 0;
    for (const auto& order : pairs)
      if (isSame(order, pair)) named += probability[static_cast<std::size_t>(order.truth)] * order.probability;
    if (named <
        0.5 * (probability[static_cast<std::size_t>(pair.truth)] + probability[static_cast<std::size_t>(pair.other)]))
      unlikely.push_back(pair);
  }
  return unlikely;
}

/// Sets the pairs that repeats cannot separate, and how often the chosen measurements must be measured until all other
/// pairs are decided with the probability `options.assured`.
void countTimes(const RivalForecast& forecast, const std::vector<double>& probability,
                const DiscriminationOptions& options, DiscriminatingMeasurements& result) {
  const double gap = separationNeeded(options.required_probability);
  result.never = unlikelyPairs(probability, pairsOf(forecast, options.most_repeats, gap));
  if (2 * result.never.size() == result.pairs.size()) return;
  for (result.times = 1; result.times < options.most_repeats; ++result.times) {
    throwIfStopped(options.hooks.stop);
    auto pairs = result.times == 1 ? result.pairs : pairsOf(forecast, result.times, gap);
    std::erase_if(pairs, [&](const DiscriminatedPair& pair) {
      return std::ranges::any_of(result.never, [&](const DiscriminatedPair& never) { return isSame(never, pair); });
    });
    if (chanceOfNaming(probability, pairs) >= options.assured) return;
  }
}

/// Returns the indices of the explanations that the chosen measurements cannot separate from some other explanation;
/// all indices if no measurement could be chosen.
std::vector<int> leftTogether(const DiscriminatingMeasurements& result) {
  std::set<int> some;
  for (const auto& pair : result.never) some.insert({pair.truth, pair.other});
  if (result.pairs.empty())
    for (int k = 0; k < static_cast<int>(result.explanations.size()); ++k) some.insert(k);
  return {some.begin(), some.end()};
}

/// Returns advice on quantities to record with further measurements, for effects that could not be tried.
std::vector<std::string> columnsMissing(const Diagnosis& diagnosis) {
  std::vector<std::string> approach_directions, columns;
  deflection::OfEachCondition<std::vector<std::string>> of_condition;
  for (const auto& kind : deflection::effectKinds()) {
    const std::string name = kind.name;
    const bool was_left_out =
        std::ranges::any_of(diagnosis.not_tried, [&](const std::string& why) { return why.starts_with(name + ":"); });
    if (!was_left_out) continue;
    if (kind.needs.approach_directions) approach_directions.push_back(name);
    for (const auto condition : conditionsOf(kind)) of_condition[condition].push_back(name);
  }
  const auto add = [&](const std::vector<std::string>& effects, const std::string& what) {
    if (effects.empty()) return;
    std::string names;
    for (const auto& effect : effects) names += (names.empty() ? "" : ", ") + effect;
    columns.push_back(what + " (" + names + " could not be tried without)");
  };
  add(approach_directions, "record the direction of each joint's last motion, <joint>_dir");
  for (const auto& kind : deflection::kConditionKinds)
    add(of_condition[kind.condition], std::string("record the ") + kind.name);
  return columns;
}

}  // namespace

double separationNeeded(double required_probability) {
  return 2 * std::log(required_probability / (1 - required_probability));
}

std::string nameOf(const Explanation& explanation) {
  std::string name;
  for (const auto& effect : explanation.effects)
    name += (name.empty() ? "" : " with ") + effect.effect + "@" + effect.at;
  return name.empty() ? "nothing missing" : name;
}

std::vector<Explanation> openExplanations(const Diagnosis& diagnosis, int most) {
  std::vector<Explanation> open;
  if (diagnosis.verdict == Verdict::kAmbiguous) open = diagnosis.alternatives;
  if (diagnosis.verdict == Verdict::kInconclusive) {
    open.push_back(nothingMissing(diagnosis));
    for (const auto& explanation : diagnosis.closest) open.push_back(explanation);
  }
  if (static_cast<int>(open.size()) > most) open.resize(static_cast<std::size_t>(most));
  return open;
}

namespace {

DiscriminatingMeasurements proposed(const Diagnosis& diagnosis, const std::vector<Measurement>& measurements,
                                    const std::vector<MeasurementCandidate>& candidates,
                                    const DiscriminationOptions& options) {
  DiscriminatingMeasurements result;
  if (diagnosis.verdict != Verdict::kAmbiguous && diagnosis.verdict != Verdict::kInconclusive) {
    result.status = DiscriminationStatus::kNothingToDiscriminate;
    result.reason = "the verdict is conclusive";
    return result;
  }
  result.columns = columnsMissing(diagnosis);
  result.explanations = openExplanations(diagnosis, options.most_explanations);
  const FittedBasis basis =
      basisOf(diagnosis.baseline, picked(measurements, placesFitted(measurements, diagnosis.set_aside)));
  if (result.explanations.size() < 2 || !basis.residual.ok) {
    result.status = DiscriminationStatus::kNothingToDiscriminate;
    result.reason = diagnosis.verdict == Verdict::kAmbiguous
                        ? "one known cause and an unknown one remain: more readings of this kind decide"
                        : "no effect is probable enough to choose readings for";
    return result;
  }
  reportProgress(options.hooks, "next readings");
  const auto rivals = rivalModelsOf(basis, result.explanations);
  const auto predictions = predictByRivals(rivals, candidates, options.hooks.stop);
  result.measurements = chooseDiscriminating(rivals, predictions, options.count, options.hooks.stop);
  if (result.measurements.empty()) {
    result.status = DiscriminationStatus::kNoCandidates;
    result.reason = "no posture is clear of collisions with a shape that converges";
  } else {
    const RivalForecast forecast{rivals, predictions, result.measurements};
    const auto probability = probabilitiesOf(rivals);
    result.pairs = pairsOf(forecast, 1, separationNeeded(options.required_probability));
    result.least_expected = std::ranges::min(result.pairs, {}, &DiscriminatedPair::expected).expected;
    result.probability = chanceOfNaming(probability, result.pairs);
    countTimes(forecast, probability, options, result);
    result.status = DiscriminationStatus::kDone;
  }
  if (const auto together = leftTogether(result); together.size() > 1)
    result.alternative_measurements = findAlternativeMeasurements(
        picked(rivals, together), picked(result.explanations, together), candidates, measurements, options);
  return result;
}

}  // namespace

DiscriminatingMeasurements proposeDiscriminatingMeasurements(const Diagnosis& diagnosis,
                                                             const std::vector<Measurement>& measurements,
                                                             const std::vector<MeasurementCandidate>& candidates,
                                                             const DiscriminationOptions& options) {
  return unlessStopped(&DiscriminatingMeasurements::status, DiscriminationStatus::kStopped,
                       [&] { return proposed(diagnosis, measurements, candidates, options); });
}

}  // namespace tubeplan::calibration
