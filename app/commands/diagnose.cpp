// tubeplan diagnose: which physical effect the model lacks.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.hpp"
#include "app/cli/json_target.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/commands/reading_answer.hpp"
#include "app/documents/diagnosis_pages.hpp"
#include "app/documents/diagnosis_text.hpp"
#include "app/documents/discrimination_json.hpp"
#include "app/documents/effect_warnings_json.hpp"
#include "app/documents/fill_in_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/files/atomic_file.hpp"
#include "app/jobs/comparison.hpp"
#include "app/jobs/diagnosis.hpp"

namespace tubeplan::app {

namespace {

struct DiagnoseOptions {
  std::string cell, json, run_sheet;
  ReportTarget report;
  ReadingFiles measurements;
  MeasurementOptions given;
  DiagnosisRequest request;
};

int run(const DiagnoseOptions& options) {
  const CellReadings input = readCellReadings(options.cell, options.measurements, options.given);
  checkJsonTarget(options.json);
  checkReportTarget(options.report);
  if (!options.run_sheet.empty()) checkWritableFile(options.run_sheet, "--run-sheet");
  const auto outcome = diagnoseModel(input, options.request, terminalWorkHooks());
  if (options.report.isWanted())
    writeReport(options.report, diagnosisPage(input, options.request.seed, outcome.figures,
                                              testedPatterns(input, options.request.seed, terminalWorkHooks())));
  writeJson(options.json, outcome.figures);
  const auto& sheet = outcome.run_sheet;
  const Units& units = input.cell.units;
  if (!options.run_sheet.empty() && !sheet.empty())
    writeFileAtomically(options.run_sheet, runSheetCsv(sheet, input.cell.arm, units), "--run-sheet");
  const ExitCode answer = answerOver(input.checks, true);
  if (!printsText(options.json)) return answer;
  fmt::print("{}", checksText(input.checks, units));
  if (calibration::grossMistake(input.checks)) {
    fmt::print("{}\n{}\n", nameOf(outcome.diagnosis.verdict), diagnosisSentence(outcome.diagnosis, units));
    return answer;
  }
  fmt::print("{}{}", diagnosisText(outcome.diagnosis, input.readings, units), discriminationText(outcome.figures));
  if (!options.run_sheet.empty())
    fmt::print("{}", sheet.empty() ? "no run sheet: no reading is proposed\n"
                                   : fmt::format("wrote {}: {} and give it after the readings\n", options.run_sheet,
                                                 fillInText(sheet, input.cell.arm, units)));
  fmt::print("{}", additionCommand(outcome.diagnosis, options.cell, units));
  for (const auto& warning : warningTexts(outcome.warnings, units)) fmt::print("  warning: {}\n", warning);
  return answer;
}

}  // namespace

Run configureDiagnose(CLI::App& cli) {
  const auto options = std::make_shared<DiagnoseOptions>();
  addCell(cli, options->cell);
  addReadings(cli, options->measurements);
  cli.add_option("--effects", options->request.effects, "the most effects in one explanation")->check(CLI::Range(1, 4));
  cli.add_option("--next", options->request.next,
                 "how many further readings to propose where the verdict is not conclusive")
      ->check(CLI::Range(1, 50))
      ->capture_default_str();
  addMeasurementOptions(cli, options->given);
  addSeed(cli, options->request.seed, "seed of the simulated noise and the folds");
  cli.add_option("--run-sheet", options->run_sheet,
                 "write the proposed readings (CSV), to be filled in and given back after the readings");
  addReportOptions(cli, options->report, "write a self-contained report (HTML) to this file");
  addJson(cli, options->json);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
