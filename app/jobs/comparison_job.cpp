#include "app/jobs/comparison_job.hpp"

#include "app/documents/comparison_json.hpp"
#include "app/documents/diagnosis_views_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/files/input_error.hpp"
#include "app/files/reading_input.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/studies/model/cell_fit.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

namespace {

/// A refusal is bad input: a list `identify` that names no parameters, readings that tell nothing.
void requireCompared(const calibration::Comparison& result, const CellReadings& input) {
  if (result.status == calibration::ComparisonStatus::kDone) return;
  if (result.verdict != calibration::Adequacy::kNotRun) return;
  if (!result.problems.empty())
    throw InputError(input.cell.path + " (identify)", result.problems.front().found, result.problems.front().expected);
  throw refusalOf(result.refit.reading_problem, result.reason, input);
}

/// Errors as the page's pictures take them: measured less predicted, at the tip's place after the refit.
void addPictures(const Cell& cell, nlohmann::json& json) {
  const auto reversed = [](const nlohmann::json& error) {
    nlohmann::json turned = nlohmann::json::array();
    for (const auto& part : error) turned.push_back(part.is_number() ? nlohmann::json(-part.get<double>()) : part);
    return turned;
  };
  json["joints"] = jointsJson(cell.arm, cell.units);
  for (auto& reading : json["readings"]) {
    reading["position"] = reading["position_after"];
    reading["before"] = reversed(reading["error_before"]);
    reading["after"] = reversed(reading["error_after"]);
  }
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

std::string comparisonPage(const CellReadings& input, const ComparisonRequest& request, const nlohmann::json& figures) {
  nlohmann::json page = figures;
  page.update({{"title", "Comparison of " + input.cell.name},
               {"cell", input.cell.name},
               {"measurements", input.file},
               {"seed", request.seed},
               {"version", kVersion}});
  addPictures(input.cell, page);
  return renderComparisonReport(page);
}

}  // namespace tubeplan::app
