#include "app/jobs/comparison.hpp"

#include "app/documents/comparison_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/files/input_error.hpp"
#include "app/files/reading_input.hpp"
#include "app/studies/model/cell_fit.hpp"
#include "calibration/estimation/set_aside.hpp"

namespace tubeplan::app {

namespace {

/// A refusal is bad input: a list `identify` that names no parameters, readings that determine nothing.
void requireCompared(const calibration::Comparison& result, const CellReadings& input) {
  if (result.status == calibration::ComparisonStatus::kDone) return;
  if (result.verdict != calibration::Adequacy::kNotRun) return;
  if (!result.problems.empty())
    throw InputError(input.cell.path + " (identify)", result.problems.front().found, result.problems.front().expected);
  throw refusalOf(result.refit.reading_problem, result.reason, input);
}

calibration::ComparisonOptions comparisonOptions(const CellReadings& input, const ComparisonRequest& request,
                                                 const WorkHooks& hooks) {
  calibration::ComparisonOptions options;
  options.refit.free = freeNumbersOf(input.cell);
  options.refit.folds = request.folds;
  options.refit.seed = request.seed;
  options.refit.intervals_by_profile = false;
  options.hooks = hooks;
  return options;
}

/// Readings off by more than noise explains; none of readings with a mistake in them, which is to be mended first.
std::vector<int> outliersOf(const CellReadings& input, const calibration::Comparison& all,
                            const calibration::ComparisonOptions& options) {
  if (input.checks.is_overruled || calibration::grossMistake(input.checks)) return {};
  const auto start = startOf(input.cell, input.readings);
  calibration::IdentificationOptions fit = options.refit;
  fit.hooks = withoutProgress(options.hooks);
  fit.folds = 0;
  fit.may_hold_all = true;
  const bool is_fitted = all.refit.status != calibration::IdentificationStatus::kNotRun;
  return calibration::readingsToSetAside(
      start, input.readings, is_fitted ? all.refit : calibration::identify(start, input.readings, fit), fit);
}

/// Where readings have a mistake in them no model is adequate for them, however well it fits.
void withholdVerdict(const CellReadings& input, calibration::Comparison& comparison) {
  if (comparison.verdict != calibration::Adequacy::kAdequate || !calibration::grossMistake(input.checks)) return;
  comparison.verdict = calibration::Adequacy::kInconclusive;
  comparison.grounds.emplace_back("a mistake is suspected in the readings");
}

}  // namespace

ComparisonOutcome compareModel(const CellReadings& input, const ComparisonRequest& request, const WorkHooks& hooks,
                               const calibration::Identification* refitted) {
  const auto& cell = input.cell;
  calibration::ComparisonOptions options = comparisonOptions(input, request, hooks);
  options.refitted = refitted;
  ComparisonOutcome outcome;
  outcome.readings = input.readings;
  outcome.comparison = calibration::compare(startOf(cell, input.readings), input.readings, options);
  requireGoingOn(hooks);
  requireCompared(outcome.comparison, input);
  if (const auto aside = outliersOf(input, outcome.comparison, options); !aside.empty()) {
    for (const int k : aside) outcome.set_aside.push_back(input.readings[static_cast<std::size_t>(k)].id);
    outcome.readings = calibration::withoutReadings(input.readings, aside);
    options.refitted = nullptr;
    outcome.comparison = calibration::compare(startOf(cell, outcome.readings), outcome.readings, options);
    requireGoingOn(hooks);
    requireCompared(outcome.comparison, input);
  }
  withholdVerdict(input, outcome.comparison);
  const auto& readings = outcome.readings;
  outcome.figures = comparisonJson(outcome.comparison, readings, cell.units);
  if (outcome.comparison.refit.status != calibration::IdentificationStatus::kNotRun)
    outcome.warnings = fitWarnings(outcome.comparison.refit, readings);
  outcome.figures["warnings"] = warningsWithChecks(input.checks, outcome.warnings, cell.units);
  outcome.figures["set_aside"] = outcome.set_aside;
  addChecks(input.checks, cell.units, outcome.figures);
  return outcome;
}

nlohmann::json testedPatterns(const CellReadings& input, std::uint64_t seed, const WorkHooks& hooks) {
  try {
    return compareModel(input, {.folds = 0, .seed = seed}, hooks).figures.value("tested", nlohmann::json::array());
  } catch (const InputError&) {
    return nlohmann::json::array();
  }
}

}  // namespace tubeplan::app
