#include "app/jobs/comparison.hpp"

#include <algorithm>

#include "app/documents/comparison_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/jobs/cell_estimate.hpp"
#include "app/studies/model/cell_fit.hpp"

namespace tubeplan::app {

namespace {

/// Throws InputError for a refused comparison: `identify` lists a name that is not a parameter, or the measurements
/// determine no parameter.
void requireCompared(const calibration::Comparison& result, const CellMeasurements& input) {
  if (result.status == calibration::ComparisonStatus::kDone) return;
  if (result.verdict != calibration::Adequacy::kNotRun) return;
  if (!result.problems.empty()) refuseName(input.cell.path + " (identify)", result.problems.front(), input.cell.arm);
  throw refusalOf(result.refit.measurement_problem, result.reason, input);
}

calibration::ComparisonOptions comparisonOptions(const CellMeasurements& input, const ComparisonRequest& request,
                                                 const WorkHooks& hooks) {
  calibration::ComparisonOptions options;
  options.refit.free = freeNumbersOf(input.cell);
  options.refit.folds = request.folds;
  options.refit.seed = request.seed;
  options.refit.intervals_by_profile = false;
  options.refit.hooks = hooks;
  options.hooks = hooks;
  return options;
}

bool isAnythingFree(const calibration::PlacedArm& start, const calibration::IdentificationOptions& options) {
  const bool has_base = options.free.base && std::any_of(start.base_poses.begin(), start.base_poses.end(),
                                                         [](const auto& base) { return !base.is_known; });
  return has_base || !options.free.names.empty();
}

/// Sets every verdict to inconclusive, regardless of the fit, because the measurements contain a mistake.
void withholdVerdict(const std::string& mistake, calibration::Comparison& comparison) {
  comparison.grounds = {mistake};
  for (auto* verdict : {&comparison.verdict, &comparison.as_it_stands.adequacy, &comparison.after_refit.adequacy})
    *verdict = calibration::Adequacy::kInconclusive;
}

}  // namespace

RefitOfMeasurements refitMeasurements(const CellMeasurements& input, const ComparisonRequest& request,
                                      const WorkHooks& hooks) {
  const calibration::IdentificationOptions options = comparisonOptions(input, request, hooks).refit;
  const auto fitted = [&](const std::vector<calibration::Measurement>& measurements) {
    const auto start = startOf(input.cell, measurements);
    auto fit = isAnythingFree(start, options) ? calibration::identify(start, measurements, options)
                                              : calibration::Identification{};
    throwIfJobStopped(hooks);
    return fit;
  };
  const auto outliers = [&](const calibration::Identification& fit) {
    auto aside = outliersOf(input, fit, options);
    throwIfJobStopped(hooks);
    return aside;
  };
  return fitWithoutOutliers(input.measurements, fitted, outliers);
}

ComparisonOutcome compareModel(const CellMeasurements& input, const ComparisonRequest& request, const WorkHooks& hooks,
                               const RefitOfMeasurements* made) {
  const auto& cell = input.cell;
  const RefitOfMeasurements refit = made ? *made : refitMeasurements(input, request, hooks);
  calibration::ComparisonOptions options = comparisonOptions(input, request, hooks);
  if (refit.fit.status != calibration::IdentificationStatus::kNotRun) options.refitted = &refit.fit;
  ComparisonOutcome outcome;
  outcome.measurements = refit.measurements;
  outcome.set_aside = refit.set_aside;
  outcome.comparison = calibration::compare(startOf(cell, refit.measurements), refit.measurements, options);
  throwIfJobStopped(hooks);
  requireCompared(outcome.comparison, input);
  const std::string mistake = mistakeText(input.checks, cell.units);
  if (!mistake.empty()) withholdVerdict(mistake, outcome.comparison);
  const auto& measurements = outcome.measurements;
  outcome.figures = comparisonJson(outcome.comparison, measurements, outcome.set_aside.size(), cell.units);
  if (!mistake.empty()) outcome.figures["verdict_words"] = kMistakeWords;
  if (outcome.comparison.refit.status != calibration::IdentificationStatus::kNotRun)
    outcome.warnings = fitWarnings(outcome.comparison.refit, measurements);
  outcome.figures["warnings"] = warningsWithChecks(input.checks, outcome.warnings, cell.units);
  outcome.figures["set_aside"] = outcome.set_aside;
  addChecks(input.checks, cell.units, outcome.figures);
  return outcome;
}

nlohmann::json testedPatterns(const CellMeasurements& input, std::uint64_t seed, const WorkHooks& hooks) {
  try {
    return compareModel(input, {.folds = 0, .seed = seed}, hooks).figures.value("tested", nlohmann::json::array());
  } catch (const InputError&) {
    return nlohmann::json::array();
  }
}

}  // namespace tubeplan::app
