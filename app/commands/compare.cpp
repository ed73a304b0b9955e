// `tubeplan compare`: shows where a model's error occurs, how large it is, and which variables it depends on.
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/commands/measurement_answer.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/comparison_json.hpp"
#include "app/documents/diagnosis_pages.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/jobs/comparison.hpp"
#include "app/storage/atomic_file.hpp"

namespace tubeplan::app {

namespace {

struct CompareOptions {
  std::string cell;
  FiguresTarget figures;
  ReportTarget report;
  MeasurementFiles measurement_files;
  MeasurementOptions given;
  ComparisonRequest request;
};

int run(const CompareOptions& options) {
  const CellMeasurements input = readCellMeasurements(options.cell, options.measurement_files, options.given);
  checkFigures(options.figures);
  checkReportTarget(options.report);
  const auto [comparison, measurements, set_aside, warnings, figures] =
      compareModel(input, options.request, terminalWorkHooks());
  if (options.report.isWanted()) writeReport(options.report, comparisonPage(input, options.request.seed, figures));
  showFigures(options.figures, figures,
              checksText(input.checks, input.cell.units) + comparisonText(figures) + warningsText(warnings));
  return answerOver(input.checks, comparison.verdict == calibration::Adequacy::kAdequate);
}

}  // namespace

Run configureCompare(CLI::App& cli) {
  const auto options = std::make_shared<CompareOptions>();
  addCell(cli, options->cell);
  addMeasurements(cli, options->measurement_files);
  addMeasurementOptions(cli, options->given);
  addReportOptions(cli, options->report, "write a report with maps and curves of the error to this file (HTML)");
  cli.add_option("--folds", options->request.folds, "folds of the cross-validation by pose; 0 for none")
      ->check(within(0, 100));
  addSeed(cli, options->request.seed, "seed of the folds");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
