// tubeplan compare: where the model fails, by how much, and what its error follows.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/atomic_file.hpp"
#include "app/command.hpp"
#include "app/command_inputs.hpp"
#include "app/comparison_json.hpp"
#include "app/diagnosis_views_json.hpp"
#include "app/input_error.hpp"
#include "app/readers/cell_reader.hpp"
#include "app/readers/measurements_reader.hpp"
#include "app/reading_input.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

namespace {

struct CompareOptions {
  std::string cell, measurements, json, report;
  double sigma = 0;
  int folds = 5;
  std::uint64_t seed = 1;
};

/// A refusal is bad input: a list `identify` that names no parameters, readings that tell nothing.
void requireCompared(const calibration::Comparison& result, const CompareOptions& options) {
  if (result.status == calibration::ComparisonStatus::kDone) return;
  if (result.verdict != calibration::Adequacy::kNotRun) return;
  if (!result.problems.empty())
    throw InputError(options.cell + " (identify)", result.problems.front().found, result.problems.front().expected);
  throw InputError(options.measurements, result.reason, "readings that tell the free parameters", "");
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

int run(const CompareOptions& options) {
  const Cell cell = readCell(options.cell);
  auto readings = readMeasurements(options.measurements, cell.arm, cell.sheet ? &*cell.sheet : nullptr);
  stateSigma(readings, cell, options.measurements, options.sigma);
  requireDefinedFormulas(readings, cell, options.measurements);
  checkJsonTarget(options.json);
  if (!options.report.empty()) checkWritableFile(options.report, "--report");
  calibration::ComparisonOptions comparison;
  comparison.refit.free = {cell.identify, !cell.base_known};
  comparison.refit.folds = options.folds;
  comparison.refit.seed = options.seed;
  comparison.refit.intervals_by_profile = false;
  const auto start = calibration::placeForReadings(cell.arm, cell.X_WB, cell.base_known, readings);
  const auto result = calibration::compare(start, readings, comparison);
  requireCompared(result, options);
  nlohmann::json json = comparisonJson(result, readings, cell.units);
  json["warnings"] = nlohmann::json::array();
  if (result.refit.status != calibration::IdentificationStatus::kNotRun)
    json["warnings"] = readingWarnings(result.refit, readings, cell);
  writeJson(options.json, json);
  if (!options.report.empty()) {
    json.update({{"title", "Comparison of " + cell.name},
                 {"cell", cell.name},
                 {"measurements", options.measurements},
                 {"seed", options.seed},
                 {"version", kVersion}});
    addPictures(cell, json);
    writeFileAtomically(options.report, renderComparisonReport(json), "--report");
  }
  if (printsText(options.json)) {
    fmt::print("{}", comparisonText(result, readings, cell.units));
    for (const auto& warning : json["warnings"]) fmt::print("  warning: {}\n", warning.get<std::string>());
  }
  return result.verdict == calibration::Adequacy::kAdequate ? kDone : kNegativeAnswer;
}

}  // namespace

Run configureCompare(CLI::App& cli) {
  const auto options = std::make_shared<CompareOptions>();
  cli.add_option("CELL", options->cell, "the cell file")->required();
  cli.add_option("MEASUREMENTS", options->measurements, "readings of any kind (CSV)")->required();
  cli.add_option("--sigma", options->sigma,
                 "noise of a coordinate where the file states none, in the cell's length unit");
  cli.add_option("--report", options->report, "write a page with maps and curves of the error to this file (HTML)");
  cli.add_option("--folds", options->folds, "folds of the cross-validation by pose; 0 for none")
      ->check(CLI::Range(0, 100));
  cli.add_option("--seed", options->seed, "seed of the folds");
  cli.add_option("--json", options->json, "write the figures as JSON to this file, or - for standard output");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
