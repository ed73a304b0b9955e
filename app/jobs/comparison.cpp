#include "app/jobs/comparison.hpp"

#include "app/documents/comparison_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/files/input_error.hpp"
#include "app/files/reading_input.hpp"
#include "app/studies/model/cell_fit.hpp"

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

}  // namespace

ComparisonOutcome compareModel(const CellReadings& input, const ComparisonRequest& request, const WorkHooks& hooks,
                               const calibration::Identification* refitted) {
  const auto& cell = input.cell;
  const auto& readings = input.readings;
  calibration::ComparisonOptions comparison;
  comparison.refit.free = freeNumbersOf(cell);
  comparison.refit.folds = request.folds;
  comparison.refit.seed = request.seed;
  comparison.refit.intervals_by_profile = false;
  comparison.hooks = hooks;
  comparison.refitted = refitted;
  ComparisonOutcome outcome;
  outcome.comparison = calibration::compare(startOf(cell, readings), readings, comparison);
  requireGoingOn(hooks);
  requireCompared(outcome.comparison, input);
  outcome.figures = comparisonJson(outcome.comparison, readings, cell.units);
  if (outcome.comparison.refit.status != calibration::IdentificationStatus::kNotRun)
    outcome.warnings = fitWarnings(outcome.comparison.refit, readings);
  outcome.figures["warnings"] = warningsWithChecks(input.checks, outcome.warnings, cell.units);
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
