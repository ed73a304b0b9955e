#include "calibration/diagnosis/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "calibration/diagnosis/explanations/indistinguishable.hpp"
#include "calibration/diagnosis/explanations/size_sets.hpp"
#include "calibration/diagnosis/judgement/decision.hpp"
#include "calibration/diagnosis/judgement/measurements_kept_out.hpp"
#include "calibration/diagnosis/judgement/posterior.hpp"
#include "calibration/diagnosis/judgement/ranking.hpp"
#include "calibration/diagnosis/judgement/remainder.hpp"
#include "calibration/diagnosis/model_selection/leading_models.hpp"
#include "calibration/diagnosis/model_selection/model_search.hpp"
#include "calibration/diagnosis/model_selection/noise_hypotheses.hpp"
#include "calibration/estimation/evidence.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/set_aside.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

namespace {

constexpr std::size_t kMostClosest = 8;
// Tolerance of the baseline fit, relative to chi-square. It is loose, because each model is refitted from the baseline.
constexpr double kBaselineTolerance = 1e-6;
// Log odds against a measurement being an outlier. An outlier may be wrong by up to 30 standard deviations per
// coordinate.
constexpr double kOutlier = 14.8;

IdentificationOptions baselineOptions(const DiagnosisOptions& options) {
  IdentificationOptions baseline = options.baseline;
  baseline.folds = 0;
  baseline.intervals_by_profile = false;
  baseline.may_hold_all = true;
  baseline.hooks = withoutProgress(options.hooks);
  if (baseline.solver.method == LeastSquaresMethod::kHybrid && !baseline.solver.tolerance)
    baseline.solver.tolerance = kBaselineTolerance;
  return baseline;
}

Identification fitBaseline(const PlacedArm& start, const std::vector<Measurement>& measurements,
                           const DiagnosisOptions& options, RobustLoss loss = RobustLoss::kNone) {
  reportProgress(options.hooks, "fit");
  IdentificationOptions how = baselineOptions(options);
  if (loss != RobustLoss::kNone) how.loss = loss;
  Identification baseline = identify(start, measurements, how);
  throwIfStopped(options.hooks.stop);
  return baseline;
}

/// Intermediate result with the working data that it was computed from. Errors on held-out measurements, detectable
/// sizes of effects and data of plots are computed only for the final result.
struct Answer {
  explicit Answer(const DiagnosisOptions& options) : work{options, {}, {}, nullptr, nullptr, {}, {}, {}} {}

  Diagnosis result;
  DiagnosisWork work;
  std::vector<Measurement> held_out;
  bool is_found = false;  ///< true if competing models exist in `work`
};

void describeBaseline(const DiagnosisWork& work, Diagnosis& result) {
  const auto& residual = work.basis.residual;
  result.chi2 = residual.r.squaredNorm();
  result.degrees_of_freedom = result.baseline.degrees_of_freedom;
  result.p_value = chiSquareTail(result.chi2, result.degrees_of_freedom);
  result.noise_floor = noiseFloor(work.basis.measurements, work.basis.weights);
  result.before = errorSize(work.basis.measurements, work.basis.weights, residual.error);
}

/// Returns the reason why no verdict is possible; empty if a verdict is possible.
std::string inconclusiveSince(const DiagnosisWork& work, const Diagnosis& result) {
  const int numbers = work.basis.weights.degrees_of_freedom - result.degrees_of_freedom;
  auto problem = findLackOfFreedom(work.basis.measurements, result.degrees_of_freedom, numbers);
  if (!problem) problem = findOverstatedNoise(result.chi2, result.degrees_of_freedom);
  return problem ? problem->what + "; needed: " + problem->needed : "";
}

/// Compares the models by their linear evidence, provided that a verdict is possible.
void weighModels(Answer& answer) {
  Diagnosis& result = answer.result;
  result.reason = inconclusiveSince(answer.work, result);
  if (!result.reason.empty()) {
    result.verdict = Verdict::kInconclusive;
    return;
  }
  if (!linearize(answer.work)) {
    result.reason = "the model cannot be evaluated at the readings";
    return;
  }
  answer.is_found = true;
  result.not_tried = answer.work.causes.not_tried;
  compareModels(answer.work);
}

/// Treats the scatter of repeated measurements as noise if it is as large as the model's errors, even if it exceeds the
/// stated noise.
void takeRepeatsForNoise(const DiagnosisWork& work, const CompetingModel& model, Diagnosis& result) {
  const Repeats repeats = repeatsBy(work, model);
  const bool is_larger =
      repeats.noise_ratio > 1 && !areBeyondNoise(repeats) && disagreesWithStatedNoise(repeats, kLackOfFit);
  if (!is_larger || !(repeats.lack_of_fit_p_value >= kLackOfFit)) return;
  result.repeats = repeats;
  result.remainder = {};
  if (result.verdict == Verdict::kPartlyExplained) {
    result.verdict = Verdict::kExplained;
    return;
  }
  result.verdict = Verdict::kAdequate;
  result.nothing_probability += result.scatter_probability;
  result.scatter_probability = 0;
}

/// Withdraws the verdict "adequate" if the residuals are too large for noise alone: `compare` would reject the model at
/// this chi-square.
void withholdAdequate(const DiagnosisWork& work, Diagnosis& result) {
  if (result.verdict != Verdict::kAdequate || !(result.p_value < kLackOfFit)) return;
  takeRepeatsForNoise(work, modelOfNothing(work), result);
  if (result.repeats.groups > 0) return;
  result.verdict = Verdict::kInconclusive;
  result.reason =
      "noise alone leaves residuals as large as these in fewer than 1 of 100 cases, and no known effect is likely; "
      "more readings or a known sigma are needed";
}

/// Sets the verdict from the fits of the leading models.
void conclude(Answer& answer) {
  DiagnosisWork& work = answer.work;
  Diagnosis& result = answer.result;
  if (!answer.is_found) return;
  fitLeaders(work);
  const Posterior posterior = posteriorOf(work);
  for (const ModelClass& model_class : posterior.classes)
    if (result.closest.size() < kMostClosest) result.closest.push_back(model_class.explanation);
  decide(work.options, posterior, result);
  withholdAdequate(work, result);
  rankCauses(work, result);
  result.nothing_criterion = -2 * modelOfNothing(work).logWeight();
  const CompetingModel& best = work.models.front();
  result.model_error = best.model_error;
  const bool is_part = result.verdict == Verdict::kPartlyExplained;
  if (!is_part && result.verdict != Verdict::kUnexplained) return;
  const CompetingModel& named = is_part ? posterior.certain_model : best;
  result.remainder = remainderOf(work, named);
  if (is_part ? result.remainder.follows.empty() : result.isScatterAlone()) takeRepeatsForNoise(work, named, result);
}

/// Returns the baseline and the models that compete with it, without a verdict.
Answer compareAll(Identification baseline, const std::vector<Measurement>& all, const std::vector<int>& set_aside,
                  const DiagnosisOptions& options) {
  Answer found(options);
  found.result.set_aside = set_aside;
  std::vector<Measurement> used;
  for (const Measurement& measurement : withoutMeasurements(all, set_aside))
    (measurement.is_held_out ? found.held_out : used).push_back(measurement);
  found.result.baseline = std::move(baseline);
  const auto status = found.result.baseline.status;
  const bool is_usable = (status == IdentificationStatus::kDone || status == IdentificationStatus::kNotConverged) &&
                         !found.result.baseline.fitted.arm.rows.empty();
  if (is_usable) found.work.basis = basisOf(found.result.baseline, used, options.hooks.stop);
  throwIfStopped(options.hooks.stop);
  if (!found.work.basis.residual.ok) {
    found.result.reason = found.result.baseline.reason.empty() ? "the model cannot be evaluated at the readings"
                                                               : found.result.baseline.reason;
    return found;
  }
  describeBaseline(found.work, found.result);
  weighModels(found);
  return found;
}

/// Sets the root-mean-square distance [m] between the tips that each alternative and the first alternative predict over
/// the arm's range.
void setDistances(const DiagnosisWork& work, Diagnosis& result) {
  if (result.alternatives.size() < 2) return;
  const RangeViews views(work.basis, work.options.seed);
  const auto first = views.tipsBy(result.alternatives.front());
  for (auto& alternative : result.alternatives)
    if (const auto tips = views.tipsBy(alternative); tips.size() == first.size() && tips.size() > 0)
      alternative.distance_from_first = std::sqrt((tips - first).squaredNorm() * 3 / static_cast<double>(tips.size()));
}

Diagnosis completed(Answer found, const std::vector<Measurement>& all) {
  Diagnosis& result = found.result;
  if (!found.work.basis.residual.ok || !found.is_found) return std::move(result);
  listDetectable(found.work, result);
  for (auto& alternative : result.alternatives) findSizeSets(found.work.basis, alternative);
  judgeByMeasurementsKeptOut(found.work, found.held_out, result);
  setDistances(found.work, result);
  throwIfStopped(found.work.options.hooks.stop);
  result.views = viewsOf(found.work.basis, result, all);
  return std::move(result);
}

/// Returns the log weight of the best model for all measurements; measurements that were set aside are treated as
/// outliers.
double bestWeight(const Answer& found, const std::vector<Measurement>& measurements) {
  if (!found.is_found) return -std::numeric_limits<double>::infinity();
  const auto& best = found.work.models.front();
  // The model does not predict measurements that are set aside. Each contributes the mean log density of noise, minus
  // the log odds against an outlier.
  const double outliers = countOutliers(found.result.set_aside, measurements);
  const auto set_aside = static_cast<double>(found.result.set_aside.size());
  const auto& weights = found.work.noise.front().weights;
  const double density = found.work.basis.measurements.empty()
                             ? 0
                             : logDensityOf(weights) / static_cast<double>(found.work.basis.measurements.size());
  return best.logWeight() + set_aside * density - outliers * kOutlier;
}

/// Returns the possible error of the models' log weights due to linearised evidence.
double windowOf(const Answer& found) {
  if (!found.is_found) return 0;
  return leaderWindow(found.work.models.front().logWeight(), modelOfNothing(found.work).logWeight());
}

Diagnosis concluded(Answer found, const std::vector<Measurement>& all) {
  conclude(found);
  return completed(std::move(found), all);
}

Diagnosis diagnosed(const PlacedArm& start, const std::vector<Measurement>& measurements,
                    const DiagnosisOptions& options) {
  Identification baseline = fitBaseline(start, measurements, options);
  const BaselineFit fit = [&](const std::vector<Measurement>& some, RobustLoss loss) {
    return fitBaseline(start, some, options, loss);
  };
  std::optional<WithoutOutliers> without = withoutOutliers(measurements, baseline, options.baseline.outlier_level, fit);
  Answer with_all = compareAll(std::move(baseline), measurements, {}, options);
  if (!without || !with_all.is_found) return concluded(std::move(with_all), measurements);
  // If the base slips between touches of one point, these touches also look like outliers. Causes that explain all
  // measurements therefore compete with the best model without the outliers.
  Answer without_outliers = compareAll(std::move(without->fit), measurements, without->set_aside, options);
  const double before = bestWeight(with_all, measurements), after = bestWeight(without_outliers, measurements);
  if (std::abs(before - after) > std::max(windowOf(with_all), windowOf(without_outliers)))
    return concluded(after > before ? std::move(without_outliers) : std::move(with_all), measurements);
  conclude(with_all);
  conclude(without_outliers);
  return completed(bestWeight(without_outliers, measurements) > bestWeight(with_all, measurements)
                       ? std::move(without_outliers)
                       : std::move(with_all),
                   measurements);
}

}  // namespace

Diagnosis diagnose(const PlacedArm& start, const std::vector<Measurement>& measurements,
                   const DiagnosisOptions& options) {
  return unlessStopped(&Diagnosis::verdict, Verdict::kStopped, [&] { return diagnosed(start, measurements, options); });
}

CompetingExplanations competingExplanations(const PlacedArm& start, const std::vector<Measurement>& measurements,
                                            const DiagnosisOptions& options,
                                            const std::vector<std::vector<deflection::Effect>>& requested) {
  std::vector<Measurement> used = measurements;
  std::erase_if(used, [](const Measurement& measurement) { return measurement.is_held_out; });
  try {
    Answer found = compareAll(fitBaseline(start, used, options), used, {}, options);
    if (!found.is_found) return {};
    fitLeaders(found.work);
    CompetingExplanations all;
    for (const CompetingModel& model : found.work.models)
      if (model.hasFit()) all.found.push_back(model.fit);
    std::ranges::stable_sort(all.found, {}, &Explanation::criterion);
    for (const auto& effects : requested) all.requested.push_back(fittedModelOf(found.work, effects).fit);
    return all;
  } catch (const WorkStopped&) {
    return {};
  }
}

}  // namespace tubeplan::calibration
