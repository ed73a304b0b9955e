#include "calibration/diagnosis/discriminating_measurements.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "calibration/diagnosis/alternative_measurements.hpp"
#include "calibration/diagnosis/rival_prediction.hpp"

namespace tubeplan::calibration {

namespace {

std::vector<Measurement> fittedReadings(const Diagnosis& diagnosis, const std::vector<Measurement>& readings) {
  std::vector<Measurement> fitted;
  for (int k = 0; k < static_cast<int>(readings.size()); ++k)
    if (!readings[static_cast<std::size_t>(k)].is_held_out &&
        !std::binary_search(diagnosis.set_aside.begin(), diagnosis.set_aside.end(), k))
      fitted.push_back(readings[static_cast<std::size_t>(k)]);
  return fitted;
}

Explanation nothingMissing(const Diagnosis& diagnosis) {
  Explanation nothing;
  nothing.fitted = diagnosis.baseline.fitted;
  nothing.chi2 = diagnosis.chi2;
  nothing.criterion = diagnosis.nothing_criterion;
  return nothing;
}

/// Standard normal, below x.
double below(double x) { return std::erfc(-x / std::numbers::sqrt2) / 2; }

std::vector<DiscriminatedPair> pairsOf(const std::vector<RivalModel>& rivals,
                                       const std::vector<RivalPrediction>& predictions,
                                       const std::vector<DiscriminationStep>& steps, double gap) {
  std::vector<DiscriminatedPair> pairs;
  for (int a = 0; a < static_cast<int>(rivals.size()); ++a)
    for (int b = 0; b < static_cast<int>(rivals.size()); ++b) {
      if (a == b) continue;
      const ExpectedRise rise = expectedRise(rivals, predictions, steps, a, b, 1);
      DiscriminatedPair pair{
          a, b, rivals[static_cast<std::size_t>(b)].criterion - rivals[static_cast<std::size_t>(a)].criterion};
      pair.expected = pair.now + rise.mean;
      pair.probability = below((pair.expected - gap) / std::max(1e-9, rise.sigma));
      pairs.push_back(pair);
    }
  return pairs;
}

/// The chance that the true one is named alone, each counted by how probable the readings so far make it.
double chanceOfNaming(const std::vector<RivalModel>& rivals, const std::vector<DiscriminatedPair>& pairs) {
  double least = std::numeric_limits<double>::infinity(), total = 0, named = 0;
  for (const RivalModel& rival : rivals) least = std::min(least, rival.criterion);
  for (int a = 0; a < static_cast<int>(rivals.size()); ++a) {
    const double weight = std::exp(-(rivals[static_cast<std::size_t>(a)].criterion - least) / 2);
    double chance = 1;
    for (const auto& pair : pairs)
      if (pair.truth == a) chance = std::min(chance, pair.probability);
    total += weight;
    named += weight * chance;
  }
  return named / total;
}

/// How often the choice must be made until this pair's gap is passed in the mean; 0 where the most allowed do not.
int timesNeeded(const std::vector<RivalModel>& rivals, const std::vector<RivalPrediction>& predictions,
                const std::vector<DiscriminationStep>& steps, const DiscriminatedPair& pair,
                const DiscriminationOptions& options) {
  if (pair.expected >= separationNeeded(options.sure)) return 1;
  for (int times = 2; times <= options.most_repeats; ++times)
    if (pair.now + expectedRise(rivals, predictions, steps, pair.truth, pair.other, times).mean >=
        separationNeeded(options.sure))
      return times;
  return 0;
}

/// A pair counts as split where one of its orders is: where the other order never is, its second contains its first as
/// a special case, and only parsimony speaks against it.
void countTimes(const std::vector<RivalModel>& rivals, const std::vector<RivalPrediction>& predictions,
                const std::vector<DiscriminationStep>& steps, const DiscriminationOptions& options,
                DiscriminatingMeasurements& result) {
  std::map<std::pair<int, int>, int> times;
  for (const auto& pair : result.pairs) {
    goOn(options.hooks.stop);
    times[{pair.truth, pair.other}] = timesNeeded(rivals, predictions, steps, pair, options);
  }
  for (const auto& pair : result.pairs) {
    if (pair.truth > pair.other) continue;
    const int most = std::max(times[{pair.truth, pair.other}], times[{pair.other, pair.truth}]);
    result.times = std::max(result.times, most);
    if (most == 0) result.never.push_back(pair);
  }
}

/// The explanations that no posture splits from another; all where no reading can be made.
std::vector<int> leftTogether(const DiscriminatingMeasurements& result) {
  std::set<int> some;
  for (const auto& pair : result.never) some.insert({pair.truth, pair.other});
  if (result.pairs.empty())
    for (int k = 0; k < static_cast<int>(result.explanations.size()); ++k) some.insert(k);
  return {some.begin(), some.end()};
}

template <class Item>
std::vector<Item> picked(const std::vector<Item>& all, const std::vector<int>& which) {
  std::vector<Item> some;
  for (const int k : which) some.push_back(all[static_cast<std::size_t>(k)]);
  return some;
}

/// What to write down beside a reading, for effects that the readings gave no chance.
std::vector<std::string> columnsMissing(const Diagnosis& diagnosis) {
  std::vector<std::string> approach_directions, temperature, time, columns;
  for (const auto& kind : deflection::effectKinds()) {
    const std::string name = kind.name;
    const bool was_left_out = std::any_of(diagnosis.not_tried.begin(), diagnosis.not_tried.end(),
                                          [&](const std::string& why) { return why.starts_with(name + ":"); });
    if (!was_left_out) continue;
    if (kind.needs.approach_directions) approach_directions.push_back(name);
    if (kind.needs.temperature) temperature.push_back(name);
    if (kind.needs.time) time.push_back(name);
  }
  const auto add = [&](const std::vector<std::string>& effects, const std::string& what) {
    if (effects.empty()) return;
    std::string names;
    for (const auto& effect : effects) names += (names.empty() ? "" : ", ") + effect;
    columns.push_back(what + " (" + names + " could not be tried without)");
  };
  add(approach_directions, "record the direction of each joint's last motion, <joint>_dir");
  add(temperature, "record the temperature");
  add(time, "record the time");
  return columns;
}

}  // namespace

double separationNeeded(double sure) { return 2 * std::log(sure / (1 - sure)); }

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

DiscriminatingMeasurements proposeUnlessStopped(const Diagnosis& diagnosis, const std::vector<Measurement>& readings,
                                                const std::vector<ReadingCandidate>& candidates,
                                                const DiscriminationOptions& options) {
  DiscriminatingMeasurements result;
  if (diagnosis.verdict != Verdict::kAmbiguous && diagnosis.verdict != Verdict::kInconclusive) {
    result.status = DiscriminationStatus::kNothingToDiscriminate;
    result.reason = "the verdict is conclusive";
    return result;
  }
  result.columns = columnsMissing(diagnosis);
  result.explanations = openExplanations(diagnosis, options.most_explanations);
  const DiagnosisBasis basis = basisOf(diagnosis.baseline, fittedReadings(diagnosis, readings));
  if (result.explanations.size() < 2 || !basis.residual.ok) {
    result.status = DiscriminationStatus::kNothingToDiscriminate;
    result.reason = diagnosis.verdict == Verdict::kAmbiguous
                        ? "one known cause and an unknown one remain: more readings of this kind decide"
                        : "no effect is probable enough to choose readings for";
    return result;
  }
  tell(options.hooks, "next readings");
  const auto rivals = rivalModelsOf(basis, result.explanations);
  const auto predictions = predictByRivals(rivals, candidates, options.hooks.stop);
  const auto steps = chooseDiscriminating(rivals, predictions, options.count, options.hooks.stop);
  if (steps.empty()) {
    result.status = DiscriminationStatus::kNoCandidates;
    result.reason = "no posture is clear of collisions with a shape that converges";
  } else {
    for (const auto& step : steps) result.readings.push_back({step.candidate, step.a, step.b, step.separation});
    result.pairs = pairsOf(rivals, predictions, steps, separationNeeded(options.sure));
    result.least_expected = leastExpected(rivals, predictions, steps);
    result.probability = chanceOfNaming(rivals, result.pairs);
    countTimes(rivals, predictions, steps, options, result);
    result.status = DiscriminationStatus::kDone;
  }
  if (const auto together = leftTogether(result); together.size() > 1)
    result.alternative_measurements = findAlternativeMeasurements(
        picked(rivals, together), picked(result.explanations, together), candidates, readings, options);
  return result;
}

}  // namespace

DiscriminatingMeasurements proposeDiscriminatingMeasurements(const Diagnosis& diagnosis,
                                                             const std::vector<Measurement>& readings,
                                                             const std::vector<ReadingCandidate>& candidates,
                                                             const DiscriminationOptions& options) {
  try {
    return proposeUnlessStopped(diagnosis, readings, candidates, options);
  } catch (const WorkStopped&) {
    DiscriminatingMeasurements stopped;
    stopped.status = DiscriminationStatus::kStopped;
    stopped.reason = kStoppedReason;
    return stopped;
  }
}

}  // namespace tubeplan::calibration
