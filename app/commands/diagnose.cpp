// `tubeplan diagnose`: names the physical effect that the model lacks.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/commands/measurement_answer.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/diagnosis_json.hpp"
#include "app/documents/diagnosis_pages.hpp"
#include "app/documents/effect_warnings_json.hpp"
#include "app/documents/fill_in_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/jobs/comparison.hpp"
#include "app/jobs/diagnosis.hpp"
#include "app/storage/atomic_file.hpp"

namespace tubeplan::app {

namespace {

struct DiagnoseOptions {
  std::string cell, run_sheet;
  FiguresTarget figures;
  ReportTarget report;
  MeasurementFiles measurements;
  MeasurementOptions given;
  DiagnosisRequest request;
};

/// Returns a message on the run sheet: the written file and how to use it, or why none was written. Empty without
/// --run-sheet or if the measurements contain a mistake.
std::string sheetText(const DiagnoseOptions& options, const CellMeasurements& input,
                      const std::vector<calibration::ProposedMeasurement>& sheet) {
  if (options.run_sheet.empty() || calibration::firstMistake(input.checks)) return "";
  if (sheet.empty()) return "no run sheet: no reading is proposed\n";
  return fmt::format("wrote {}: {} and pass it after the readings\n", options.run_sheet,
                     fillInText(sheet, input.cell.arm, input.cell.units));
}

int run(const DiagnoseOptions& options) {
  const CellMeasurements input = readCellMeasurements(options.cell, options.measurements, options.given);
  checkFigures(options.figures);
  checkReportTarget(options.report);
  if (!options.run_sheet.empty()) checkWritableFile(options.run_sheet, "--run-sheet");
  const auto outcome = diagnoseModel(input, options.request, terminalWorkHooks());
  if (options.report.isWanted())
    writeReport(options.report, diagnosisPage(input, options.request.seed, outcome.figures,
                                              testedPatterns(input, options.request.seed, terminalWorkHooks())));
  const auto& sheet = outcome.run_sheet;
  const Units& units = input.cell.units;
  if (!options.run_sheet.empty() && !sheet.empty())
    writeFileAtomically(options.run_sheet, runSheetCsv(sheet, input.cell.arm, units), "--run-sheet");
  showFigures(options.figures, outcome.figures,
              checksText(input.checks, units) + diagnosisText(outcome.figures) + sheetText(options, input, sheet) +
                  additionCommand(outcome.figures, options.cell) + warningsText(warningTexts(outcome.warnings, units)));
  return answerOver(input.checks, true);
}

}  // namespace

Run configureDiagnose(CLI::App& cli) {
  const auto options = std::make_shared<DiagnoseOptions>();
  addCell(cli, options->cell);
  addMeasurements(cli, options->measurements);
  cli.add_option("--effects", options->request.effects, "largest number of effects in one explanation")
      ->check(within(1, 4));
  cli.add_option("--next", options->request.next,
                 "number of further readings to propose if the verdict is not conclusive")
      ->check(within(1, 50))
      ->capture_default_str();
  addMeasurementOptions(cli, options->given);
  addSeed(cli, options->request.seed, "seed of the simulated noise and the folds");
  cli.add_option("--run-sheet", options->run_sheet,
                 "write the proposed readings (CSV), to be filled in and given back after the readings");
  addReportOptions(cli, options->report, "write a self-contained report (HTML) to this file");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
