#include "app/improvement_job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "app/diagnosis_json.hpp"
#include "app/input_error.hpp"
#include "app/readers/cell_writer.hpp"

namespace tubeplan::app {

namespace {

using calibration::Diagnosis, calibration::Explanation, calibration::Verdict;

constexpr double kWorthIt = 0.95;  // of the held-out error: what an effect must at least bring it down to

/// What a diagnosis says to add: its explanation; where none is enough, the closest if it is worth it on readings kept
/// out. Nothing otherwise.
const Explanation* worthAdding(const Diagnosis& diagnosis) {
  if (!diagnosis.alternatives.empty()) return &diagnosis.alternatives.front();
  if (diagnosis.verdict != Verdict::kUnexplained || diagnosis.closest.empty()) return nullptr;
  const Explanation& closest = diagnosis.closest.front();
  return closest.heldout.rms < kWorthIt * diagnosis.heldout_before.rms ? &closest : nullptr;
}

calibration::Identification fitOf(const Cell& cell, const std::vector<calibration::Measurement>& readings,
                                  std::uint64_t seed) {
  calibration::IdentificationOptions options;
  options.free = {cell.identify, !cell.base_known};
  options.seed = seed;
  return calibration::identify(cell.arm, cell.X_WB, cell.base_known, readings, options);
}

}  // namespace

Improvement improveModel(const CellReadings& input, const ImprovementRequest& request, const StepHook& step) {
  const auto& readings = input.readings;
  Improvement result{input.cell, {}, {}, {}};
  beginStep(step, "fit");
  result.last = fitOf(result.cell, readings, request.seed);
  result.rungs.push_back(rungOf("as given", result.last));
  for (int round = 0; round < request.steps; ++round) {
    beginStep(step, fmt::format("diagnosis {}", round + 1));
    calibration::DiagnosisOptions diagnosis_options;
    diagnosis_options.baseline.free = {result.cell.identify, !result.cell.base_known};
    diagnosis_options.seed = request.seed;
    const auto start =
        calibration::placeForReadings(result.cell.arm, result.cell.X_WB, result.cell.base_known, readings);
    const Diagnosis diagnosis = calibration::diagnose(start, readings, diagnosis_options);
    result.steps.push_back({diagnosis.verdict, diagnosisSentence(diagnosis, result.cell.units), {}});
    const Explanation* explanation = worthAdding(diagnosis);
    if (!explanation) break;
    for (const auto& effect : explanation->effects) {
      result.cell.arm.effects.push_back(effect.fitted);
      for (const auto& name : freedNames(result.cell.arm, effect.fitted)) result.cell.identify.push_back(name);
      result.steps.back().added.push_back(effect.effect + "@" + effect.at);
    }
    result.last = fitOf(result.cell, readings, request.seed);
    result.rungs.push_back(rungOf(fmt::format("+ {}", fmt::join(result.steps.back().added, " + ")), result.last));
  }
  if (const auto& problem = result.last.reading_problem) throw inputErrorOf(*problem, readings, input.file);
  if (result.last.status == calibration::IdentificationStatus::kRefused)
    throw InputError(input.file, result.last.reason, "readings that tell the free parameters", "");
  return result;
}

nlohmann::json improvementJson(const Improvement& result) {
  nlohmann::json json = ladderJson(result.rungs, result.cell.units);
  json["steps"] = nlohmann::json::array();
  for (const auto& step : result.steps)
    json["steps"].push_back({{"verdict", nameOf(step.verdict)}, {"sentence", step.sentence}, {"added", step.added}});
  return json;
}

}  // namespace tubeplan::app
