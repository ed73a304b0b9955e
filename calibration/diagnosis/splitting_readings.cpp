#include "calibration/diagnosis/splitting_readings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "calibration/diagnosis/foretelling.hpp"
#include "calibration/diagnosis/other_means.hpp"

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

std::vector<SplitPair> pairsOf(const std::vector<Rival>& rivals, const std::vector<Foretold>& foretold,
                               const std::vector<SplittingStep>& steps, double gap) {
  std::vector<SplitPair> pairs;
  for (int a = 0; a < static_cast<int>(rivals.size()); ++a)
    for (int b = 0; b < static_cast<int>(rivals.size()); ++b) {
      if (a == b) continue;
      const ExpectedRise rise = expectedRise(rivals, foretold, steps, a, b, 1);
      SplitPair pair{a, b,
                     rivals[static_cast<std::size_t>(b)].criterion - rivals[static_cast<std::size_t>(a)].criterion};
      pair.expected = pair.now + rise.mean;
      pair.probability = below((pair.expected - gap) / std::max(1e-9, rise.sigma));
      pairs.push_back(pair);
    }
  return pairs;
}

/// The chance that the true one is named alone, each counted by how probable the readings so far make it.
double chanceOfNaming(const std::vector<Rival>& rivals, const std::vector<SplitPair>& pairs) {
  double least = std::numeric_limits<double>::infinity(), total = 0, named = 0;
  for (const Rival& rival : rivals) least = std::min(least, rival.criterion);
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
int timesNeeded(const std::vector<Rival>& rivals, const std::vector<Foretold>& foretold,
                const std::vector<SplittingStep>& steps, const SplitPair& pair, const SplittingOptions& options) {
  if (pair.expected >= separatingGap(options.sure)) return 1;
  for (int times = 2; times <= options.most_repeats; ++times)
    if (pair.now + expectedRise(rivals, foretold, steps, pair.truth, pair.other, times).mean >=
        separatingGap(options.sure))
      return times;
  return 0;
}

/// A pair counts as split where one of its orders is: where the other order never is, its second contains its first as
/// a special case, and only parsimony speaks against it.
void countTimes(const std::vector<Rival>& rivals, const std::vector<Foretold>& foretold,
                const std::vector<SplittingStep>& steps, const SplittingOptions& options, SplittingReadings& result) {
  std::map<std::pair<int, int>, int> times;
  for (const auto& pair : result.pairs) {
    goOn(options.hooks.stop);
    times[{pair.truth, pair.other}] = timesNeeded(rivals, foretold, steps, pair, options);
  }
  for (const auto& pair : result.pairs) {
    if (pair.truth > pair.other) continue;
    const int most = std::max(times[{pair.truth, pair.other}], times[{pair.other, pair.truth}]);
    result.times = std::max(result.times, most);
    if (most == 0) result.never.push_back(pair);
  }
}

/// The explanations that no posture splits from another; all where no reading can be made.
std::vector<int> leftTogether(const SplittingReadings& result) {
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
  std::vector<std::string> senses, temperature, time, columns;
  for (const auto& kind : deflection::effectKinds()) {
    const std::string name = kind.name;
    const bool was_left_out = std::any_of(diagnosis.not_tried.begin(), diagnosis.not_tried.end(),
                                          [&](const std::string& why) { return why.starts_with(name + ":"); });
    if (!was_left_out) continue;
    if (kind.needs.senses) senses.push_back(name);
    if (kind.needs.temperature) temperature.push_back(name);
    if (kind.needs.time) time.push_back(name);
  }
  const auto add = [&](const std::vector<std::string>& effects, const std::string& what) {
    if (effects.empty()) return;
    std::string names;
    for (const auto& effect : effects) names += (names.empty() ? "" : ", ") + effect;
    columns.push_back(what + " (" + names + " could not be tried without)");
  };
  add(senses, "record the sense of each joint's last motion, <joint>_dir");
  add(temperature, "record the temperature");
  add(time, "record the time");
  return columns;
}

}  // namespace

double separatingGap(double sure) { return 2 * std::log(sure / (1 - sure)); }

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

SplittingReadings proposeUnlessStopped(const Diagnosis& diagnosis, const std::vector<Measurement>& readings,
                                       const std::vector<ReadingCandidate>& candidates,
                                       const SplittingOptions& options) {
  SplittingReadings result;
  if (diagnosis.verdict != Verdict::kAmbiguous && diagnosis.verdict != Verdict::kInconclusive) {
    result.status = SplittingStatus::kNothingToSplit;
    result.reason = "the verdict leaves nothing open";
    return result;
  }
  result.columns = columnsMissing(diagnosis);
  result.explanations = openExplanations(diagnosis, options.most_explanations);
  const DiagnosisBasis basis = basisOf(diagnosis.baseline, fittedReadings(diagnosis, readings));
  if (result.explanations.size() < 2 || !basis.residual.ok) {
    result.status = SplittingStatus::kNothingToSplit;
    result.reason = diagnosis.verdict == Verdict::kAmbiguous
                        ? "one cause is left beside something unknown: more readings of this kind decide"
                        : "no effect stands out enough to aim readings at";
    return result;
  }
  tell(options.hooks, "next readings");
  const auto rivals = rivalsOf(basis, result.explanations);
  const auto foretold = foretell(rivals, candidates, options.hooks.stop);
  const auto steps = chooseSplitting(rivals, foretold, options.count, options.hooks.stop);
  if (steps.empty()) {
    result.status = SplittingStatus::kNoCandidates;
    result.reason = "no posture is clear and settles";
  } else {
    for (const auto& step : steps) result.readings.push_back({step.candidate, step.a, step.b, step.separation});
    result.pairs = pairsOf(rivals, foretold, steps, separatingGap(options.sure));
    result.least_expected = leastExpected(rivals, foretold, steps, 1);
    result.probability = chanceOfNaming(rivals, result.pairs);
    countTimes(rivals, foretold, steps, options, result);
    result.status = SplittingStatus::kDone;
  }
  if (const auto together = leftTogether(result); together.size() > 1)
    result.other_means =
        findOtherMeans(picked(rivals, together), picked(result.explanations, together), candidates, readings, options);
  return result;
}

}  // namespace

SplittingReadings proposeSplittingReadings(const Diagnosis& diagnosis, const std::vector<Measurement>& readings,
                                           const std::vector<ReadingCandidate>& candidates,
                                           const SplittingOptions& options) {
  try {
    return proposeUnlessStopped(diagnosis, readings, candidates, options);
  } catch (const WorkStopped&) {
    SplittingReadings stopped;
    stopped.status = SplittingStatus::kStopped;
    stopped.reason = kStoppedReason;
    return stopped;
  }
}

}  // namespace tubeplan::calibration
