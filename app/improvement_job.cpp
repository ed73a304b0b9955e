#include "app/improvement_job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "app/cell_fit.hpp"
#include "app/diagnosis_json.hpp"
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
                                  std::uint64_t seed, const WorkHooks& hooks) {
  calibration::IdentificationOptions options;
  options.free = freeNumbersOf(cell);
  options.seed = seed;
  options.hooks = hooks;
  auto fit = calibration::identify(startOf(cell, readings), readings, options);
  requireGoingOn(hooks);
  return fit;
}

Diagnosis diagnosisOf(const Cell& cell, const std::vector<calibration::Measurement>& readings, std::uint64_t seed,
                      const WorkHooks& hooks) {
  calibration::DiagnosisOptions options;
  options.baseline.free = freeNumbersOf(cell);
  options.seed = seed;
  options.hooks = hooks;
  Diagnosis diagnosis = calibration::diagnose(startOf(cell, readings), readings, options);
  requireGoingOn(hooks);
  return diagnosis;
}

}  // namespace

Improvement improveModel(const CellReadings& input, const ImprovementRequest& request, const WorkHooks& hooks) {
  const auto& readings = input.readings;
  Improvement result{input.cell, {}, {}, {}};
  beginStep(hooks, "fit");
  result.last = fitOf(result.cell, readings, request.seed, hooks);
  result.rungs.push_back(rungOf("as given", result.last));
  for (int round = 0; round < request.steps; ++round) {
    const WorkHooks of_round = within(hooks, fmt::format("diagnosis {}", round + 1));
    const Diagnosis diagnosis = diagnosisOf(result.cell, readings, request.seed, of_round);
    result.steps.push_back({diagnosis.verdict, diagnosisSentence(diagnosis, result.cell.units), {}});
    const Explanation* explanation = worthAdding(diagnosis);
    if (!explanation) break;
    for (const auto& effect : explanation->effects) {
      result.cell.arm.effects.push_back(effect.fitted);
      for (const auto& name : freedNames(result.cell.arm, effect.fitted)) result.cell.identify.push_back(name);
      result.steps.back().added.push_back(effect.effect + "@" + effect.at);
    }
    result.last = fitOf(result.cell, readings, request.seed, of_round);
    result.rungs.push_back(rungOf(fmt::format("+ {}", fmt::join(result.steps.back().added, " + ")), result.last));
  }
  if (result.last.status == calibration::IdentificationStatus::kRefused)
    throw refusalOf(result.last.reading_problem, result.last.reason, input);
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
