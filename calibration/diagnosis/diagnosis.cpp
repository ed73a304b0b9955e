#include "calibration/diagnosis/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "calibration/diagnosis/hypothesis.hpp"
#include "calibration/diagnosis/smooth_misfit.hpp"
#include "calibration/held_out.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr double kTwinFall = 20;  // criterion beyond the best to which candidates are fitted too
constexpr int kMostLeaders = 14;
constexpr int kMostAlternatives = 8;
constexpr int kPairsFitted = 10;
constexpr int kPairFirsts = 40;  // candidates, best first, that pairs are made of

/// One set of variants with its fall of chi-square to first order.
struct Scored {
  std::vector<int> variants;
  double fall = 0;
  double criterion = 0;  ///< numbers ln n - fall
};

struct Work {
  const DiagnosisOptions& options;
  Identification baseline;
  DiagnosisBasis basis;
  Catalogue catalogue;
  ScoreSpace space;
  double log_n = 0;
};

/// The best variant of each candidate, best first.
std::vector<Scored> bestVariants(const Work& work) {
  std::map<int, Scored> best;
  const auto& variants = work.space.variants();
  for (int v = 0; v < static_cast<int>(variants.size()); ++v) {
    const Score score = work.space.score({v});
    if (!score.is_physical) continue;
    const Scored scored{{v}, score.fall, variants[static_cast<std::size_t>(v)].numbers * work.log_n - score.fall};
    const auto [at, is_new] = best.emplace(variants[static_cast<std::size_t>(v)].candidate, scored);
    if (!is_new && scored.criterion < at->second.criterion) at->second = scored;
  }
  std::vector<Scored> list;
  for (const auto& [candidate, scored] : best) list.push_back(scored);
  std::stable_sort(list.begin(), list.end(),
                   [](const Scored& a, const Scored& b) { return a.criterion < b.criterion; });
  return list;
}

std::vector<Explanation> fitAll(const Work& work, const std::vector<Scored>& some) {
  std::vector<Explanation> fits;
  for (const Scored& scored : some) {
    Explanation fit = fitExplanation(work.basis, work.catalogue, work.space, scored.variants);
    if (std::isfinite(fit.chi2)) fits.push_back(std::move(fit));
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const Explanation& a, const Explanation& b) { return a.criterion < b.criterion; });
  return fits;
}

/// The leaders, and all others that come near them.
std::vector<Scored> leadersOf(const Work& work, const std::vector<Scored>& singles) {
  std::vector<Scored> some;
  for (const Scored& scored : singles) {
    const bool is_near = scored.criterion < singles.front().criterion + kTwinFall;
    const auto most = static_cast<std::size_t>(is_near ? kMostLeaders : work.options.leaders);
    if (some.size() < most && scored.criterion < 0) some.push_back(scored);
  }
  return some;
}

/// Two errors of one joint's reading together follow about any function of it: they would name what is not known.
bool followOneJoint(const Catalogue& catalogue, int a, int b) {
  const auto& first = catalogue.candidates[static_cast<std::size_t>(a)].neutral;
  const auto& second = catalogue.candidates[static_cast<std::size_t>(b)].neutral;
  const auto stage = [](const deflection::Effect& effect) {
    return deflection::effectKinds()[static_cast<std::size_t>(effect.kind)].stage;
  };
  return stage(first) == deflection::EffectStage::kReading && stage(second) == deflection::EffectStage::kReading &&
         first.place.row == second.place.row;
}

std::vector<Scored> bestPairs(const Work& work, const std::vector<Scored>& singles) {
  const auto& variants = work.space.variants();
  std::map<int, std::vector<int>> of_candidate;
  for (int v = 0; v < static_cast<int>(variants.size()); ++v)
    of_candidate[variants[static_cast<std::size_t>(v)].candidate].push_back(v);
  std::vector<Scored> pairs;
  const std::size_t firsts = std::min<std::size_t>(singles.size(), kPairFirsts);
  for (std::size_t i = 0; i < firsts; ++i) {
    const int a = singles[i].variants.front();
    for (const auto& [candidate, some] : of_candidate) {
      if (candidate == variants[static_cast<std::size_t>(a)].candidate) continue;
      if (followOneJoint(work.catalogue, variants[static_cast<std::size_t>(a)].candidate, candidate)) continue;
      Scored best{{}, 0, 1e300};
      for (const int b : some) {
        const Score score = work.space.score({a, b});
        if (!score.is_physical) continue;
        const int numbers =
            variants[static_cast<std::size_t>(a)].numbers + variants[static_cast<std::size_t>(b)].numbers;
        if (numbers * work.log_n - score.fall < best.criterion)
          best = {{a, b}, score.fall, numbers * work.log_n - score.fall};
      }
      if (!best.variants.empty()) pairs.push_back(best);
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Scored& a, const Scored& b) { return a.criterion < b.criterion; });
  std::set<std::set<int>> seen;
  std::vector<Scored> distinct;
  for (const Scored& pair : pairs) {
    const std::set<int> both{variants[static_cast<std::size_t>(pair.variants[0])].candidate,
                             variants[static_cast<std::size_t>(pair.variants[1])].candidate};
    if (!seen.insert(both).second) continue;
    distinct.push_back(pair);
    if (distinct.size() == kPairsFitted) break;
  }
  return distinct;
}

std::string nameOf(const FoundEffect& effect) { return effect.effect + "@" + effect.at; }

/// Sizes that no machine has are no explanation.
bool isPlausible(const Explanation& explanation) {
  for (const auto& effect : explanation.effects) {
    const auto& kind = deflection::effectKinds()[static_cast<std::size_t>(effect.fitted.kind)];
    for (std::size_t v = 0; v < effect.numbers.size(); ++v) {
      const auto& number = effect.numbers[v];
      if (kind.parameters[v].is_shape || std::isnan(number.sigma)) continue;
      if (std::abs(number.value - kind.parameters[v].neutral) > kind.parameters[v].plausible + 2 * number.sigma)
        return false;
    }
  }
  return true;
}

bool isEnough(const Explanation& fit, double lack_of_fit) {
  return fit.p_value >= lack_of_fit && fit.smooth_p_value >= lack_of_fit;
}

std::vector<Explanation> withinGap(const std::vector<Explanation>& fits, double gap, double lack_of_fit) {
  std::vector<Explanation> some;
  for (const auto& fit : fits)
    if (fit.criterion <= fits.front().criterion + gap && isEnough(fit, lack_of_fit)) some.push_back(fit);
  return some;
}

IdentificationOptions baselineOptions(const DiagnosisOptions& options) {
  IdentificationOptions baseline = options.baseline;
  baseline.folds = 0;
  baseline.intervals_by_profile = false;
  return baseline;
}

/// Everything linearised about a baseline; `basis.residual.ok` is false where that is not possible.
Work linearize(Identification baseline, const std::vector<Measurement>& readings, const DiagnosisOptions& options) {
  Work work{options, std::move(baseline), {}, {}, {}, 0};
  const auto status = work.baseline.status;
  if (status != IdentificationStatus::kDone && status != IdentificationStatus::kNotConverged) return work;
  if (work.baseline.fitted.arm.rows.empty()) return work;
  work.basis = basisOf(work.baseline, readings);
  if (!work.basis.residual.ok) return work;
  work.log_n = std::log(std::max(2, work.basis.weights.degrees_of_freedom));
  work.catalogue = linearizeCatalogue(work.basis.fitted, work.basis.readings, work.basis.weights, options.catalogue);
  work.space = ScoreSpace(work.catalogue, work.basis.residual.jacobian, work.basis.residual.r);
  return work;
}

/// The baseline without its outliers, where they are few: what an effect moves is spread too widely to be among them.
Identification fitBaseline(const PlacedArm& start, std::vector<Measurement>& readings, const DiagnosisOptions& options,
                           std::vector<int>& set_aside) {
  const auto baseline_options = baselineOptions(options);
  Identification baseline = identify(start, readings, baseline_options);
  if (baseline.outliers.empty() || baseline.outliers.size() > readings.size() / 20) return baseline;
  for (const auto& outlier : baseline.outliers) set_aside.push_back(outlier.reading);
  std::sort(set_aside.begin(), set_aside.end());
  for (auto at = set_aside.rbegin(); at != set_aside.rend(); ++at) readings.erase(readings.begin() + *at);
  return identify(start, readings, baseline_options);
}

FoundNumber mainSize(const Work& work, const Scored& scored) {
  const Variant& variant = work.space.variants()[static_cast<std::size_t>(scored.variants.front())];
  const Candidate& candidate = work.catalogue.candidates[static_cast<std::size_t>(variant.candidate)];
  const Score score = work.space.score(scored.variants);
  Index most = 0;
  score.sizes.cwiseAbs().maxCoeff(&most);
  const int value = candidate.sizes[static_cast<std::size_t>(variant.sizes[static_cast<std::size_t>(most)])];
  const double unit = candidate.unit[static_cast<std::size_t>(value)];
  const auto& kind = deflection::effectKinds()[static_cast<std::size_t>(candidate.neutral.kind)];
  return {kind.parameters[static_cast<std::size_t>(value)].name,
          deflection::numberOf(work.basis.fitted.arm, candidate.neutral, value).quantity,
          candidate.neutral.values[static_cast<std::size_t>(value)] + score.sizes[most] * unit,
          score.sigma[most] * unit};
}

void listDetectable(const Work& work, double threshold, Diagnosis& result) {
  // Power four in five at the catalogue's own threshold: the signature must be that many sigmas long.
  const double sigmas = std::sqrt(2 * std::log(10.) * threshold) + 0.84;
  std::set<int> seen;
  const auto& variants = work.space.variants();
  for (int v = 0; v < static_cast<int>(variants.size()); ++v) {
    const Variant& variant = variants[static_cast<std::size_t>(v)];
    if (variant.sizes.size() != 1 || !seen.insert(variant.candidate).second) continue;
    const Candidate& candidate = work.catalogue.candidates[static_cast<std::size_t>(variant.candidate)];
    const int value = candidate.sizes[static_cast<std::size_t>(variant.sizes.front())];
    const auto& kind = deflection::effectKinds()[static_cast<std::size_t>(candidate.neutral.kind)];
    const double units = sigmas / std::max(1e-300, work.space.visibility(v));
    result.detectable.push_back({candidate.effect, candidate.at, kind.parameters[static_cast<std::size_t>(value)].name,
                                 deflection::numberOf(work.basis.fitted.arm, candidate.neutral, value).quantity,
                                 units * candidate.unit[static_cast<std::size_t>(value)], units > 1});
  }
}

/// Probabilities over nothing missing, each explanation that was fitted, and something unknown.
void rank(const Work& work, const std::vector<Scored>& singles, const std::vector<Explanation>& fits,
          Diagnosis& result) {
  std::map<std::string, const Explanation*> fitted;
  for (const auto& fit : fits)
    if (fit.effects.size() == 1) fitted.emplace(nameOf(fit.effects.front()), &fit);
  const double none = result.chi2;
  const double floor = result.degrees_of_freedom + 2.5 * std::sqrt(2. * result.degrees_of_freedom);
  std::vector<double> criteria;
  const double base_numbers = static_cast<double>(work.basis.unknowns.size()) * work.log_n;
  const double unknown = std::min(result.chi2, floor) + 5 * work.log_n;
  for (const Scored& scored : singles) {
    const Variant& variant = work.space.variants()[static_cast<std::size_t>(scored.variants.front())];
    const Candidate& candidate = work.catalogue.candidates[static_cast<std::size_t>(variant.candidate)];
    RankedEffect entry;
    entry.effect = candidate.effect;
    entry.at = candidate.at;
    entry.fall = scored.fall;
    entry.size = mainSize(work, scored);
    entry.kept_fraction = work.space.keptFraction(scored.variants.front());
    entry.p_value = std::pow(10., -work.space.evidence(scored.variants.front(), work.space.score(scored.variants)));
    entry.correlation = work.space.correlation(scored.variants.front(), singles.front().variants.front());
    double criterion = result.chi2 + scored.criterion;
    if (const auto at = fitted.find(entry.effect + "@" + entry.at); at != fitted.end()) {
      criterion = at->second->criterion - base_numbers;
      entry.fall = result.chi2 - at->second->chi2;
      double largest = -1;
      for (const auto& number : at->second->effects.front().numbers)
        if (std::isfinite(number.sigma) && number.sigma > 0 && std::abs(number.value) / number.sigma > largest) {
          largest = std::abs(number.value) / number.sigma;
          entry.size = number;
        }
    }
    criteria.push_back(criterion);
    result.ranking.push_back(std::move(entry));
  }
  const double least =
      std::min({none, unknown, criteria.empty() ? none : *std::min_element(criteria.begin(), criteria.end())});
  double total = std::exp(-(none - least) / 2) + std::exp(-(unknown - least) / 2);
  for (const double criterion : criteria) total += std::exp(-(criterion - least) / 2);
  for (std::size_t k = 0; k < criteria.size(); ++k)
    result.ranking[k].probability = std::exp(-(criteria[k] - least) / 2) / total;
  std::stable_sort(result.ranking.begin(), result.ranking.end(), [](const RankedEffect& a, const RankedEffect& b) {
    return a.probability != b.probability ? a.probability > b.probability : a.fall > b.fall;
  });
}

struct Finding {
  std::vector<Explanation> fits;  ///< all that were fitted, best first
  std::vector<Explanation> good;  ///< those that are enough
};

std::vector<Explanation> plausibleSingles(const Work& work, const std::vector<Scored>& singles) {
  std::vector<Explanation> fits = fitAll(work, leadersOf(work, singles));
  std::erase_if(fits, [](const Explanation& fit) { return !isPlausible(fit); });
  return fits;
}

/// Singles first; where none is enough, pairs.
Finding findExplanations(const Work& work, const std::vector<Scored>& singles) {
  Finding finding;
  const auto& options = work.options;
  finding.fits = plausibleSingles(work, singles);
  if (!finding.fits.empty()) finding.good = withinGap(finding.fits, options.gap, options.lack_of_fit);
  if (options.most_effects < 2) return finding;
  const double single = finding.fits.empty() ? 1e300 : finding.fits.front().criterion;
  std::vector<Explanation> pairs;
  for (auto& fit : fitAll(work, bestPairs(work, singles)))
    if (isPlausible(fit) && fit.criterion < single - options.gap) pairs.push_back(std::move(fit));
  if (pairs.empty()) return finding;
  const auto good = withinGap(pairs, options.gap, options.lack_of_fit);
  if (!good.empty()) finding.good = good;
  finding.fits.insert(finding.fits.end(), pairs.begin(), pairs.end());
  std::stable_sort(finding.fits.begin(), finding.fits.end(),
                   [](const Explanation& a, const Explanation& b) { return a.criterion < b.criterion; });
  return finding;
}

/// Where no model is enough, what is left is the yardstick: the noise is as large as the best of them leaves it.
void sortByRemainingNoise(const Work& work, std::vector<Explanation>& fits) {
  if (fits.empty()) return;
  const auto least = std::min_element(fits.begin(), fits.end(),
                                      [](const Explanation& a, const Explanation& b) { return a.chi2 < b.chi2; });
  const double noise = std::max(1., least->chi2 / std::max(1, work.basis.weights.degrees_of_freedom));
  const auto criterion = [&](const Explanation& fit) { return fit.criterion - fit.chi2 + fit.chi2 / noise; };
  std::stable_sort(fits.begin(), fits.end(),
                   [&](const Explanation& a, const Explanation& b) { return criterion(a) < criterion(b); });
  const double best = criterion(fits.front());
  for (auto& fit : fits) fit.is_near_best = criterion(fit) <= best + work.options.gap;
}

void decide(const Work& work, Finding finding, Diagnosis& result) {
  const bool is_seen = result.evidence > result.threshold;
  if (finding.good.empty()) sortByRemainingNoise(work, finding.fits);
  const bool is_off = result.p_value < work.options.misfit || result.smooth_p_value < work.options.misfit;
  result.closest = finding.fits;
  if (result.closest.size() > kMostAlternatives) result.closest.resize(kMostAlternatives);
  if (!is_seen && !is_off) {
    result.verdict = result.evidence > result.hint_threshold ? Verdict::kInconclusive : Verdict::kAdequate;
    return;
  }
  if (finding.good.empty()) {
    result.verdict = Verdict::kUnexplained;
    return;
  }
  const double without = result.chi2 + static_cast<double>(work.basis.unknowns.size()) * work.log_n;
  if (!is_seen || finding.good.front().criterion > without - work.options.gap) {
    result.verdict = Verdict::kInconclusive;
    return;
  }
  if (finding.good.size() > kMostAlternatives) finding.good.resize(kMostAlternatives);
  result.alternatives = std::move(finding.good);
  result.verdict = result.alternatives.size() == 1 ? Verdict::kExplained : Verdict::kAmbiguous;
}

void judgeAll(const Work& work, const std::vector<Measurement>& held_out, Diagnosis& result) {
  const auto folds = foldsOf(work.basis.readings, work.options.folds, work.options.seed);
  const ExplanationModel bare{work.basis.fitted, work.basis.unknowns};
  const auto judged = [&](const ExplanationModel& model) {
    return held_out.empty() ? judgeOnFolds(work.basis, model, folds) : judge(model.placed, held_out);
  };
  result.heldout_before = judged(bare);
  result.heldout_after = result.heldout_before;
  result.after = result.before;
  auto& explanations = result.alternatives.empty() ? result.closest : result.alternatives;
  for (std::size_t k = 0; k < explanations.size() && k < 3; ++k)
    explanations[k].heldout = judged(modelOf(work.basis, explanations[k]));
  for (auto& entry : result.ranking) {
    entry.heldout_before = result.heldout_before;
    for (const auto& explanation : explanations)
      if (explanation.effects.size() == 1 && explanation.effects.front().effect == entry.effect &&
          explanation.effects.front().at == entry.at)
        entry.heldout_after = explanation.heldout;
  }
  if (result.alternatives.empty()) return;
  result.after = result.alternatives.front().after;
  result.heldout_after = result.alternatives.front().heldout;
}

}  // namespace

Diagnosis diagnose(const PlacedArm& start, const std::vector<Measurement>& readings, const DiagnosisOptions& options) {
  Diagnosis result;
  std::vector<Measurement> used = readings, held_out;
  for (const auto& reading : readings)
    if (reading.is_held_out) held_out.push_back(reading);
  result.baseline = fitBaseline(start, used, options, result.set_aside);
  std::erase_if(used, [](const Measurement& reading) { return reading.is_held_out; });
  const Work work = linearize(result.baseline, used, options);
  if (!work.basis.residual.ok) {
    result.reason =
        result.baseline.reason.empty() ? "the model cannot be evaluated at the readings" : result.baseline.reason;
    return result;
  }
  result.not_tried = work.catalogue.not_tried;
  result.chi2 = work.basis.residual.r.squaredNorm();
  result.degrees_of_freedom = work.basis.weights.degrees_of_freedom - static_cast<int>(work.basis.unknowns.size());
  result.p_value = chiSquareTail(result.chi2, result.degrees_of_freedom);
  result.smooth_p_value = findSmoothMisfit(work.basis.fitted, used, work.basis.weights, work.basis.residual).p_value;
  result.noise_floor = noiseFloor(used, work.basis.weights);
  result.before = errorSize(used, work.basis.weights, work.basis.residual.error);
  const auto singles = bestVariants(work);
  for (int v = 0; v < static_cast<int>(work.space.variants().size()); ++v)
    result.evidence = std::max(result.evidence, work.space.evidence(v, work.space.score({v})));
  const auto thresholds = work.space.familyThresholds({options.false_alarm, options.hint}, options.draws, options.seed);
  result.threshold = thresholds[0];
  result.hint_threshold = thresholds[1];
  Finding finding;
  if (result.evidence > result.threshold || std::min(result.p_value, result.smooth_p_value) < options.misfit)
    finding = findExplanations(work, singles);
  else if (result.evidence > result.hint_threshold)
    finding.fits = plausibleSingles(work, singles);
  rank(work, singles, finding.fits, result);
  decide(work, std::move(finding), result);
  listDetectable(work, result.threshold, result);
  judgeAll(work, held_out, result);
  result.views = viewsOf(work.basis, result, readings);
  return result;
}

std::vector<Explanation> explainBySingles(const PlacedArm& start, const std::vector<Measurement>& readings,
                                          const DiagnosisOptions& options) {
  std::vector<Measurement> used = readings;
  std::erase_if(used, [](const Measurement& reading) { return reading.is_held_out; });
  const Work work = linearize(identify(start, used, baselineOptions(options)), used, options);
  if (!work.basis.residual.ok) return {};
  return plausibleSingles(work, bestVariants(work));
}

}  // namespace tubeplan::calibration
