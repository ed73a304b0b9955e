#include "app/diagnosis_job.hpp"

#include "app/diagnosis_json.hpp"
#include "app/effect_warnings_json.hpp"
#include "app/input_error.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/splitting_candidates.hpp"
#include "app/splitting_json.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

namespace {

/// Where the verdict leaves something open: what to read next.
void proposeNext(const CellReadings& input, const DiagnosisRequest& request, DiagnosisOutcome& outcome) {
  using calibration::Verdict;
  const auto& diagnosis = outcome.diagnosis;
  if (diagnosis.verdict != Verdict::kAmbiguous && diagnosis.verdict != Verdict::kInconclusive) return;
  SplittingCandidateOptions choice;
  choice.seed = request.seed;
  outcome.candidates = splittingCandidates(input.cell, diagnosis.baseline.fitted, input.readings, choice);
  calibration::SplittingOptions splitting;
  splitting.count = request.next;
  outcome.next = calibration::proposeSplittingReadings(diagnosis, input.readings, outcome.candidates, splitting);
}

calibration::DiagnosisOptions diagnosisOptions(const Cell& cell, const DiagnosisRequest& request) {
  calibration::DiagnosisOptions options;
  options.baseline.free = {cell.identify, !cell.base_known};
  options.seed = request.seed;
  options.most_effects = request.effects;
  return options;
}

}  // namespace

calibration::Diagnosis diagnoseReadings(const Cell& cell, const std::vector<calibration::Measurement>& readings,
                                        const DiagnosisRequest& request) {
  const auto start = calibration::placeForReadings(cell.arm, cell.X_WB, cell.base_known, readings);
  return calibration::diagnose(start, readings, diagnosisOptions(cell, request));
}

DiagnosisOutcome diagnoseModel(const CellReadings& input, const DiagnosisRequest& request, const StepHook& step) {
  const auto& [cell, file, readings] = input;
  const auto options = diagnosisOptions(cell, request);
  const auto start = calibration::placeForReadings(cell.arm, cell.X_WB, cell.base_known, readings);
  DiagnosisOutcome outcome;
  beginStep(step, "diagnosis");
  outcome.diagnosis = calibration::diagnose(start, readings, options);
  if (outcome.diagnosis.verdict == calibration::Verdict::kNotRun) {
    if (const auto& problem = outcome.diagnosis.baseline.reading_problem) throw inputErrorOf(*problem, readings, file);
    throw InputError(file, outcome.diagnosis.reason, "readings that tell the free parameters", "");
  }
  beginStep(step, "next readings");
  proposeNext(input, request, outcome);
  beginStep(step, "warnings");
  outcome.warnings = calibration::warnOfEffects(start, readings, options, outcome.diagnosis);
  outcome.figures = diagnosisJson(outcome.diagnosis, readings, cell.units);
  addNextReadings(outcome.next, outcome.candidates, cell.arm, cell.units, outcome.figures);
  outcome.figures["warnings"] = effectWarningsJson(outcome.warnings, cell.units);
  return outcome;
}

std::string diagnosisPage(const CellReadings& input, const DiagnosisRequest& request, const nlohmann::json& figures) {
  nlohmann::json page = figures;
  page.update({{"title", "Diagnosis of " + input.cell.name},
               {"cell", input.cell.name},
               {"measurements", input.file},
               {"seed", request.seed},
               {"version", kVersion}});
  return renderDiagnosisReport(page);
}

}  // namespace tubeplan::app
