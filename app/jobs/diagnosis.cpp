#include "app/jobs/diagnosis.hpp"

#include "app/documents/diagnosis_json.hpp"
#include "app/documents/discrimination_json.hpp"
#include "app/documents/effect_warnings_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/studies/measurements/discrimination_candidates.hpp"
#include "app/studies/model/cell_fit.hpp"

namespace tubeplan::app {

namespace {

/// Proposes further measurements if the verdict is ambiguous or inconclusive.
void proposeNext(const CellMeasurements& input, const DiagnosisRequest& request, const WorkHooks& hooks,
                 DiagnosisOutcome& outcome) {
  using calibration::Verdict;
  const auto& diagnosis = outcome.diagnosis;
  if (diagnosis.verdict != Verdict::kAmbiguous && diagnosis.verdict != Verdict::kInconclusive) return;
  DiscriminationCandidateOptions choice;
  choice.seed = request.seed;
  outcome.candidates = discriminationCandidates(input.cell, diagnosis.baseline.fitted, input.measurements, choice);
  calibration::DiscriminationOptions discrimination;
  discrimination.count = request.next;
  discrimination.hooks = hooks;
  outcome.next =
      calibration::proposeDiscriminatingMeasurements(diagnosis, input.measurements, outcome.candidates, discrimination);
  throwIfJobStopped(hooks);
}

/// Returns an outcome without a verdict, because a mistake in the measurements explains the model's error.
DiagnosisOutcome undiagnosed(const CellMeasurements& input, const std::string& mistake) {
  DiagnosisOutcome outcome;
  outcome.diagnosis.verdict = calibration::Verdict::kInconclusive;
  outcome.diagnosis.reason = mistake;
  outcome.figures = diagnosisJson(outcome.diagnosis, input.measurements, input.cell.units);
  outcome.figures["verdict_words"] = kMistakeWords;
  outcome.figures["warnings"] = nlohmann::json::array();
  addChecks(input.checks, input.cell.units, outcome.figures);
  return outcome;
}

calibration::DiagnosisOptions diagnosisOptions(const Cell& cell, const DiagnosisRequest& request) {
  calibration::DiagnosisOptions options;
  options.baseline.free = freeNumbersOf(cell);
  options.seed = request.seed;
  options.most_causes = request.effects;
  return options;
}

}  // namespace

calibration::Diagnosis diagnoseMeasurements(const Cell& cell, const std::vector<calibration::Measurement>& measurements,
                                            const DiagnosisRequest& request, const WorkHooks& hooks) {
  auto options = diagnosisOptions(cell, request);
  options.hooks = hooks;
  return calibration::diagnose(startOf(cell, measurements), measurements, options);
}

DiagnosisOutcome diagnoseModel(const CellMeasurements& input, const DiagnosisRequest& request, const WorkHooks& hooks) {
  const auto& cell = input.cell;
  const auto& measurements = input.measurements;
  auto options = diagnosisOptions(cell, request);
  options.hooks = hooks;
  const auto start = startOf(cell, measurements);
  DiagnosisOutcome outcome;
  if (const auto mistake = mistakeText(input.checks, cell.units); !mistake.empty()) return undiagnosed(input, mistake);
  outcome.diagnosis = calibration::diagnose(start, measurements, options);
  throwIfJobStopped(hooks);
  if (outcome.diagnosis.verdict == calibration::Verdict::kNotRun)
    throw refusalOf(outcome.diagnosis.baseline.measurement_problem, outcome.diagnosis.reason, input);
  beginStep(hooks, "next readings");
  proposeNext(input, request, hooks, outcome);
  beginStep(hooks, "warnings");
  outcome.warnings = calibration::warnOfEffects(start, measurements, options, outcome.diagnosis);
  throwIfJobStopped(hooks);
  outcome.figures = diagnosisJson(outcome.diagnosis, measurements, cell.units);
  addNextMeasurements(outcome.next, outcome.candidates, cell.arm, cell.units, outcome.figures);
  outcome.run_sheet = runSheetOf(outcome.next, outcome.candidates, measurements);
  if (!outcome.run_sheet.empty()) outcome.figures["run_sheet"] = runSheetCsv(outcome.run_sheet, cell.arm, cell.units);
  outcome.figures["warnings"] = effectWarningsJson(outcome.warnings, cell.units);
  addChecks(input.checks, cell.units, outcome.figures);
  return outcome;
}

}  // namespace tubeplan::app
