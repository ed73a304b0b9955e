#include "calibration/diagnosis/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "calibration/diagnosis/ranking.hpp"
#include "calibration/diagnosis/smooth_misfit.hpp"
#include "calibration/held_out.hpp"
#include "calibration/reading_prediction.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr int kMostAlternatives = 8;
constexpr std::size_t kFewOutliers = 20;  // one reading in that many, at most
constexpr double kMuchLess = 0.75;        // of the chi-square that one effect leaves: what a second must get below
constexpr double kHardlyMore = 1.1;       // of the least chi-square: errors within 5 % of each other

IdentificationOptions baselineOptions(const DiagnosisOptions& options) {
  IdentificationOptions baseline = options.baseline;
  baseline.folds = 0;
  baseline.intervals_by_profile = false;
  baseline.hooks = untold(options.hooks);
  return baseline;
}

/// Everything linearised about a baseline; `basis.residual.ok` is false where that is not possible.
DiagnosisWork linearize(Identification baseline, const std::vector<Measurement>& readings,
                        const DiagnosisOptions& options) {
  DiagnosisWork work{options, std::move(baseline), {}, {}, {}, 0};
  const auto status = work.baseline.status;
  if (status != IdentificationStatus::kDone && status != IdentificationStatus::kNotConverged) return work;
  if (work.baseline.fitted.arm.rows.empty()) return work;
  work.basis = basisOf(work.baseline, readings);
  work.basis.stop = options.hooks.stop;
  if (!work.basis.residual.ok) return work;
  work.log_n = std::log(std::max(2, work.basis.weights.degrees_of_freedom));
  work.catalogue =
      linearizeCatalogue(work.basis.fitted, work.basis.readings, work.basis.weights, options.catalogue, options.hooks);
  work.space = ScoreSpace(work.catalogue, work.basis.residual.jacobian, work.basis.residual.r);
  return work;
}

/// Where no model is enough, statistics of the noise no longer tell models apart: what is left does. Of as many
/// effects, those that leave hardly more than the best are near it; more effects come first only where they leave much
/// less.
void sortByWhatIsLeft(std::vector<Explanation>& fits) {
  const auto least = [&](bool of_pairs) {
    double chi2 = std::numeric_limits<double>::infinity();
    for (const auto& fit : fits)
      if ((fit.effects.size() > 1) == of_pairs) chi2 = std::min(chi2, fit.chi2);
    return chi2;
  };
  const double singles = least(false), pairs = least(true);
  const bool pairs_first = pairs < kMuchLess * singles;
  std::stable_sort(fits.begin(), fits.end(), [&](const Explanation& a, const Explanation& b) {
    const bool is_a_first = (a.effects.size() > 1) == pairs_first, is_b_first = (b.effects.size() > 1) == pairs_first;
    return is_a_first != is_b_first ? is_a_first : a.chi2 < b.chi2;
  });
  for (auto& fit : fits)
    fit.is_near_best =
        (fit.effects.size() > 1) == pairs_first && fit.chi2 <= kHardlyMore * (pairs_first ? pairs : singles);
}

void decide(const DiagnosisWork& work, Finding finding, Diagnosis& result) {
  const bool is_seen = result.evidence > result.threshold;
  if (finding.good.empty()) sortByWhatIsLeft(finding.fits);
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

void judgeAll(const DiagnosisWork& work, const std::vector<Measurement>& held_out, Diagnosis& result) {
  const auto folds = foldsOf(work.basis.readings, work.options.folds, work.options.seed);
  const ExplanationModel bare{work.basis.fitted, work.basis.unknowns};
  const auto judged = [&](const ExplanationModel& model) {
    return held_out.empty() ? judgeOnFolds(work.basis, model, folds) : judge(model.placed, held_out);
  };
  tell(work.options.hooks, "readings kept out");
  result.heldout_before = judged(bare);
  result.heldout_after = result.heldout_before;
  result.after = result.before;
  auto& explanations = result.alternatives.empty() ? result.closest : result.alternatives;
  const std::size_t most = std::min<std::size_t>(explanations.size(), 3);
  for (std::size_t k = 0; k < most; ++k) {
    tell(work.options.hooks, "readings kept out", k + 1, most + 1);
    explanations[k].heldout = judged(modelOf(work.basis, explanations[k]));
  }
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

/// An answer with what it was found by: errors kept out, powers and views are worked out for the one that is given.
struct Answer {
  Diagnosis result;
  DiagnosisWork work;
  std::vector<Measurement> held_out;
};

Answer answerBy(Identification baseline, const std::vector<Measurement>& all, const std::vector<int>& set_aside,
                const DiagnosisOptions& options) {
  Answer answer{{}, {options, {}, {}, {}, {}, 0}, {}};
  Diagnosis& result = answer.result;
  result.set_aside = set_aside;
  std::vector<Measurement> used;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool is_set_aside = std::binary_search(set_aside.begin(), set_aside.end(), static_cast<int>(k));
    if (!is_set_aside) (all[k].is_held_out ? answer.held_out : used).push_back(all[k]);
  }
  result.baseline = std::move(baseline);
  answer.work = linearize(result.baseline, used, options);
  const DiagnosisWork& work = answer.work;
  if (!work.basis.residual.ok) {
    result.reason =
        result.baseline.reason.empty() ? "the model cannot be evaluated at the readings" : result.baseline.reason;
    return answer;
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
  tell(options.hooks, "simulated noise");
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
  return answer;
}

Diagnosis completed(Answer answer, const std::vector<Measurement>& all) {
  Diagnosis& result = answer.result;
  if (!answer.work.basis.residual.ok) return result;
  listDetectable(answer.work, result.threshold, result);
  judgeAll(answer.work, answer.held_out, result);
  goOn(answer.work.options.hooks.stop);
  result.views = viewsOf(answer.work.basis, result, all);
  return std::move(result);
}

std::vector<Measurement> without(std::vector<Measurement> readings, const std::vector<int>& set_aside) {
  for (auto at = set_aside.rbegin(); at != set_aside.rend(); ++at) readings.erase(readings.begin() + *at);
  return readings;
}

/// With the touches that are then left alone at a point of unknown place: they tell nothing.
std::vector<int> withOrphans(const std::vector<int>& outliers, const std::vector<Measurement>& readings) {
  const auto isLeft = [&](std::size_t k) {
    return !readings[k].is_held_out && !std::binary_search(outliers.begin(), outliers.end(), static_cast<int>(k));
  };
  const auto isOfUnknownPoint = [](const Measurement& m) { return m.kind == MeasurementKind::kTouch && !m.p_W; };
  std::map<std::string, int> touches;
  for (std::size_t k = 0; k < readings.size(); ++k)
    if (isLeft(k) && isOfUnknownPoint(readings[k])) ++touches[readings[k].point];
  std::vector<int> all = outliers;
  for (std::size_t k = 0; k < readings.size(); ++k)
    if (isLeft(k) && isOfUnknownPoint(readings[k]) && touches[readings[k].point] == 1)
      all.push_back(static_cast<int>(k));
  std::sort(all.begin(), all.end());
  return all;
}

/// Of the model as it is with every outlier's rows as numbers of their own.
double criterionOf(const Identification& rest, const Diagnosis& whole, const std::vector<Measurement>& readings,
                   const std::vector<int>& outliers) {
  auto numbers = static_cast<double>(rest.numbers.size());
  for (const int k : outliers) numbers += rowsOf(readings[static_cast<std::size_t>(k)]);
  const auto rows =
      static_cast<double>(whole.degrees_of_freedom) + static_cast<double>(whole.baseline.numbers.size());
  return rest.chi2 + numbers * std::log(std::max(2., rows));
}

bool isAnswered(const Diagnosis& result) {
  return result.verdict == Verdict::kExplained || result.verdict == Verdict::kAmbiguous;
}

Identification fitBaseline(const PlacedArm& start, const std::vector<Measurement>& readings,
                           const DiagnosisOptions& options) {
  tell(options.hooks, "fit");
  Identification baseline = identify(start, readings, baselineOptions(options));
  goOn(options.hooks.stop);
  return baseline;
}

Diagnosis diagnoseUnlessStopped(const PlacedArm& start, const std::vector<Measurement>& readings,
                                const DiagnosisOptions& options) {
  Identification baseline = fitBaseline(start, readings, options);
  std::vector<int> outliers;
  for (const auto& outlier : baseline.outliers) outliers.push_back(outlier.reading);
  std::sort(outliers.begin(), outliers.end());
  const bool are_few = outliers.size() <= readings.size() / kFewOutliers;
  Answer whole = answerBy(std::move(baseline), readings, {}, options);
  if (outliers.empty() || !are_few) return completed(std::move(whole), readings);
  // What an effect moves is mostly spread too widely to be among a few outliers, but a base that slips between touches
  // of one point is not: an effect that explains every reading in fewer numbers goes before setting some aside.
  const auto set_aside = withOrphans(outliers, readings);
  Identification rest = fitBaseline(start, without(readings, set_aside), options);
  const bool is_possible = rest.status != IdentificationStatus::kRefused;
  if (!is_possible || (isAnswered(whole.result) && whole.result.alternatives.front().criterion <
                                                       criterionOf(rest, whole.result, readings, outliers)))
    return completed(std::move(whole), readings);
  return completed(answerBy(std::move(rest), readings, set_aside, options), readings);
}

}  // namespace

Diagnosis diagnose(const PlacedArm& start, const std::vector<Measurement>& readings, const DiagnosisOptions& options) {
  try {
    return diagnoseUnlessStopped(start, readings, options);
  } catch (const WorkStopped&) {
    Diagnosis stopped;
    stopped.verdict = Verdict::kStopped;
    stopped.reason = kStoppedReason;
    return stopped;
  }
}

std::vector<Explanation> explainBySingles(const PlacedArm& start, const std::vector<Measurement>& readings,
                                          const DiagnosisOptions& options) {
  std::vector<Measurement> used = readings;
  std::erase_if(used, [](const Measurement& reading) { return reading.is_held_out; });
  try {
    const DiagnosisWork work = linearize(fitBaseline(start, used, options), used, options);
    if (!work.basis.residual.ok) return {};
    return plausibleSingles(work, bestVariants(work));
  } catch (const WorkStopped&) {
    return {};
  }
}

}  // namespace tubeplan::calibration
