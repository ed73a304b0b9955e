#include "app/jobs/improvement.hpp"

#include "app/documents/measurement_checks_json.hpp"

namespace tubeplan::app {

namespace {

Improvement notImproved(const std::string& mistake) {
  Improvement result;
  result.end = ImprovementEnd::kMistake;
  ImprovementStep& step = result.steps.emplace_back();
  step.diagnosis.verdict = calibration::Verdict::kInconclusive;
  step.diagnosis.reason = mistake;
  step.reason = ImprovementReason::kMistakeExplains;
  return result;
}

}  // namespace

Improvement improveModel(const CellMeasurements& input, const ImprovementRequest& request, const WorkHooks& hooks) {
  if (const auto mistake = mistakeText(input.checks, input.cell.units); !mistake.empty()) return notImproved(mistake);
  Improvement result = improveModel(input.cell, input.measurements, request, hooks);
  if (result.end == ImprovementEnd::kNotFitted &&
      result.models.front().fit.status == calibration::IdentificationStatus::kRefused)
    throw refusalOf(result.models.front().fit.measurement_problem, result.models.front().fit.reason, input);
  return result;
}

}  // namespace tubeplan::app
