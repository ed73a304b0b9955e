// tubeplan diagnose: which physical effect the model lacks.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/atomic_file.hpp"
#include "app/command.hpp"
#include "app/command_inputs.hpp"
#include "app/diagnosis_json.hpp"
#include "app/effect_warnings_json.hpp"
#include "app/input_error.hpp"
#include "app/readers/cell_reader.hpp"
#include "app/readers/measurements_reader.hpp"
#include "app/reading_input.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/splitting_candidates.hpp"
#include "app/splitting_json.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

namespace {

struct DiagnoseOptions {
  std::string cell, measurements, json, report;
  double sigma = 0;
  int effects = 2, next = 6;
  std::uint64_t seed = 1;
};

void writeReport(const DiagnoseOptions& options, const Cell& cell, nlohmann::json figures) {
  figures.update({{"title", "Diagnosis of " + cell.name},
                  {"cell", cell.name},
                  {"measurements", options.measurements},
                  {"seed", options.seed},
                  {"version", kVersion}});
  writeFileAtomically(options.report, renderDiagnosisReport(figures), "--report");
}

/// Where the verdict leaves something open: what to read next.
struct Next {
  std::vector<calibration::ReadingCandidate> candidates;
  calibration::SplittingReadings readings;
};

Next proposeNext(const DiagnoseOptions& options, const Cell& cell, const calibration::Diagnosis& result,
                 const std::vector<calibration::Measurement>& readings) {
  using calibration::Verdict;
  if (result.verdict != Verdict::kAmbiguous && result.verdict != Verdict::kInconclusive) return {};
  SplittingCandidateOptions choice;
  choice.seed = options.seed;
  Next next{splittingCandidates(cell, result.baseline.fitted, readings, choice), {}};
  calibration::SplittingOptions splitting;
  splitting.count = options.next;
  next.readings = calibration::proposeSplittingReadings(result, readings, next.candidates, splitting);
  return next;
}

int run(const DiagnoseOptions& options) {
  const Cell cell = readCell(options.cell);
  auto readings = readMeasurements(options.measurements, cell.arm, cell.sheet ? &*cell.sheet : nullptr);
  stateSigma(readings, cell, options.measurements, options.sigma);
  requireDefinedFormulas(readings, cell, options.measurements);
  checkJsonTarget(options.json);
  if (!options.report.empty()) checkWritableFile(options.report, "--report");
  calibration::DiagnosisOptions diagnosis;
  diagnosis.baseline.free = {cell.identify, !cell.base_known};
  diagnosis.seed = options.seed;
  diagnosis.most_effects = options.effects;
  const auto start = calibration::placeForReadings(cell.arm, cell.X_WB, cell.base_known, readings);
  const auto result = calibration::diagnose(start, readings, diagnosis);
  if (result.verdict == calibration::Verdict::kNotRun)
    throw InputError(options.measurements, result.reason, "readings that tell the free parameters", "");
  const auto next = proposeNext(options, cell, result, readings);
  const auto warnings = calibration::warnOfEffects(start, readings, diagnosis, result);
  auto figures = diagnosisJson(result, readings, cell.units);
  addNextReadings(next.readings, next.candidates, cell.arm, cell.units, figures);
  figures["warnings"] = effectWarningsJson(warnings, cell.units);
  if (!options.report.empty()) writeReport(options, cell, figures);
  writeJson(options.json, figures);
  if (!printsText(options.json)) return kDone;
  fmt::print("{}{}", diagnosisText(result, readings, cell.units),
             splittingText(next.readings, next.candidates, cell.arm, cell.units));
  for (const auto& warning : warnings) fmt::print("  warning: {}\n", warningText(warning, cell.units));
  return kDone;
}

}  // namespace

Run configureDiagnose(CLI::App& cli) {
  const auto options = std::make_shared<DiagnoseOptions>();
  cli.add_option("CELL", options->cell, "the cell file")->required();
  cli.add_option("MEASUREMENTS", options->measurements, "readings of any kind (CSV)")->required();
  cli.add_option("--effects", options->effects, "the most effects in one explanation")->check(CLI::Range(1, 2));
  cli.add_option("--next", options->next,
                 "how many further readings to propose where the verdict leaves something open")
      ->check(CLI::Range(1, 50))
      ->capture_default_str();
  cli.add_option("--sigma", options->sigma,
                 "noise of a coordinate where the file states none, in the cell's length unit");
  cli.add_option("--seed", options->seed, "seed of the simulated noise and the folds");
  cli.add_option("--report", options->report, "write a self-contained page about it (HTML) to this file");
  cli.add_option("--json", options->json, "write the figures as JSON to this file, or - for standard output");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
