#include "app/jobs/improvement_job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/diagnosis_json.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/documents/model_comparison_json.hpp"
#include "app/files/reading_input.hpp"
#include "app/jobs/effect_addition.hpp"
#include "app/studies/model/cell_fit.hpp"

namespace tubeplan::app {

namespace {

using calibration::Diagnosis, calibration::Explanation, calibration::Verdict;
using calibration::IdentificationStatus;

constexpr double kWorthIt = 0.95;  // of an error: what an unsure cause must at least bring it down to
constexpr double kNoWorse = 1.05;  // of an error: what a sure cause may do to the farthest poses

ImprovedModel fitted(const std::string& name, const Cell& cell, const CellReadings& input, std::uint64_t seed,
                     const WorkHooks& hooks) {
  calibration::IdentificationOptions options;
  options.free = freeNumbersOf(cell);
  options.seed = seed;
  options.intervals_by_profile = false;
  options.hooks = hooks;
  ImprovedModel model{name, cell, calibration::identify(startOf(cell, input.readings), input.readings, options)};
  requireGoingOn(hooks);
  return model;
}

bool isUsable(const calibration::Identification& fit) { return fit.status == IdentificationStatus::kDone; }

Diagnosis diagnosisOf(const Cell& cell, const CellReadings& input, std::uint64_t seed, const WorkHooks& hooks) {
  calibration::DiagnosisOptions options;
  options.baseline.free = freeNumbersOf(cell);
  options.seed = seed;
  options.hooks = hooks;
  Diagnosis diagnosis = calibration::diagnose(startOf(cell, input.readings), input.readings, options);
  requireGoingOn(hooks);
  return diagnosis;
}

/// What a diagnosis leads to: a cause to add, or the end.
struct Decision {
  const Explanation* cause = nullptr;
  ImprovementEnd end = ImprovementEnd::kNotRun;
  std::string reason;
};

/// Of those that were judged and are worth it, most probable first, the first that no other betters by 5 % on the
/// farthest poses: less than that is their noise.
template <class IsWorthIt>
const Explanation* bestCarried(const std::vector<Explanation>& explanations, const IsWorthIt& isWorthIt) {
  const Explanation* best = nullptr;
  for (const auto& one : explanations)
    if (std::isfinite(one.farthest.rms) && isWorthIt(one) &&
        (!best || one.farthest.rms < kWorthIt * best->farthest.rms))
      best = &one;
  return best;
}

/// Equals: to be added only where it hardly matters which of them is right.
Decision amongEquals(const Diagnosis& diagnosis, const Units& units) {
  double widest = 0;
  for (const auto& alternative : diagnosis.alternatives)
    if (std::isfinite(alternative.apart)) widest = std::max(widest, alternative.apart);
  const Explanation* best = bestCarried(diagnosis.alternatives, [](const Explanation&) { return true; });
  const double gain = best ? diagnosis.heldout_before.rms - best->heldout.rms : 0;
  const bool is_close = best && widest <= gain;
  if (!is_close && diagnosis.agreed && diagnosis.agreed->heldout.rms < diagnosis.heldout_before.rms &&
      diagnosis.agreed->farthest.rms <= kNoWorse * diagnosis.farthest_before.rms)
    return {&*diagnosis.agreed, ImprovementEnd::kNotRun,
            "sure in every alternative, and it predicts the farthest poses"};
  if (!is_close)
    return {nullptr, ImprovementEnd::kAmbiguous,
            fmt::format("the alternatives differ by {} over the arm's range, more than the {} that is gained: take the "
                        "readings that `diagnose` proposes, which separate them",
                        lengthText(widest, units), lengthText(std::max(0., gain), units))};
  return {
      best, ImprovementEnd::kNotRun,
      fmt::format("the alternatives differ by {} over the arm's range, less than the {} that is gained; this one is "
                  "the most probable of those that predict the farthest poses well",
                  lengthText(widest, units), lengthText(gain, units))};
}

/// No cause is sure: one is added only for what it does to readings that it was not fitted to, near and far.
Decision amongUnsure(const Diagnosis& diagnosis) {
  const Explanation* best = bestCarried(diagnosis.closest, [&](const Explanation& one) {
    return one.heldout.rms < kWorthIt * diagnosis.heldout_before.rms &&
           one.farthest.rms < kWorthIt * diagnosis.farthest_before.rms;
  });
  if (!best)
    return {nullptr, ImprovementEnd::kNothingSure,
            "no cause is sure, and none lowers the error of readings kept out and of the farthest poses by 5 %"};
  return {best, ImprovementEnd::kNotRun,
          "not sure, but it lowers the error of readings kept out and of the farthest poses"};
}

Decision decisionOn(const Diagnosis& diagnosis, const Units& units) {
  switch (diagnosis.verdict) {
    case Verdict::kAdequate:
      return {nullptr, ImprovementEnd::kAdequate, "nothing is missing"};
    case Verdict::kExplained:
    case Verdict::kPartlyExplained:
      break;
    case Verdict::kAmbiguous:
      return amongEquals(diagnosis, units);
    case Verdict::kUnexplained:
      if (diagnosis.isScatterAlone())
        return {nullptr, ImprovementEnd::kAdequate,
                fmt::format("what is left, {} beyond the stated noise, follows nothing that the readings state",
                            lengthText(diagnosis.remainder.size, units))};
      return amongUnsure(diagnosis);
    default:
      return {nullptr, ImprovementEnd::kInconclusive,
              diagnosis.reason.empty() ? "the readings hint at something missing, but not at what" : diagnosis.reason};
  }
  const Explanation& first = diagnosis.alternatives.front();
  if (first.farthest.rms > kNoWorse * diagnosis.farthest_before.rms)
    return {
        nullptr, ImprovementEnd::kDoesNotCarryOver,
        fmt::format("by a fit to the nearer poses it makes the farthest worse, {} from {}: readings there are needed",
                    lengthText(first.farthest.rms, units), lengthText(diagnosis.farthest_before.rms, units))};
  return {&first, ImprovementEnd::kNotRun, "sure, and it predicts the farthest poses"};
}

ImprovementStep stepOf(const Diagnosis& diagnosis, const Decision& decision, const Units& units) {
  ImprovementStep step{diagnosis.verdict, diagnosisSentence(diagnosis, units), {}, {}, decision.reason, {}, {}, {}, {}};
  step.heldout_before = diagnosis.heldout_before;
  step.farthest_before = diagnosis.farthest_before;
  if (!decision.cause) return step;
  step.heldout_after = decision.cause->heldout;
  step.farthest_after = decision.cause->farthest;
  return step;
}

void keep(const ImprovementRequest& request, ImprovedModel model, Improvement& result) {
  if (request.on_model) request.on_model(model);
  result.models.push_back(std::move(model));
}

/// One round; false where the loop ends.
bool improveOnce(const CellReadings& input, const ImprovementRequest& request, const WorkHooks& hooks,
                 Improvement& result) {
  const ImprovedModel& last = result.models.back();
  const Diagnosis diagnosis = diagnosisOf(last.cell, input, request.seed, hooks);
  Decision decision = decisionOn(diagnosis, input.cell.units);
  result.steps.push_back(stepOf(diagnosis, decision, input.cell.units));
  if (decision.cause) {
    const Addition addition = addToCell(last.cell, *decision.cause);
    auto model =
        fitted(fmt::format("+ {}", fmt::join(addition.names, " + ")), addition.cell, input, request.seed, hooks);
    if (isUsable(model.fit) && model.fit.heldout.rms < last.fit.heldout.rms) {
      result.steps.back().added = addition.names;
      for (const auto& effect : decision.cause->effects)
        for (const auto& [name, at] : effect.also) result.steps.back().also.push_back(name + "@" + at);
      keep(request, std::move(model), result);
      return true;
    }
    decision = {nullptr, ImprovementEnd::kDoesNotCarryOver,
                "fitted with everything else it does not lower the error of readings kept out: it is left out"};
    result.steps.back().reason = decision.reason;
  }
  result.end = decision.end;
  return false;
}

}  // namespace

Improvement improveModel(const CellReadings& input, const ImprovementRequest& request, const WorkHooks& hooks) {
  Improvement result;
  if (const auto* mistake = calibration::grossMistake(input.checks)) {
    result.end = ImprovementEnd::kMistake;
    result.steps.push_back({Verdict::kInconclusive,
                            checkText(*mistake, input.cell.units),
                            {},
                            {},
                            "a mistake with the readings explains the error: nothing is added to the model",
                            {},
                            {},
                            {},
                            {}});
    return result;
  }
  beginStep(hooks, "fit");
  ImprovedModel first = fitted("as given", input.cell, input, request.seed, hooks);
  if (first.fit.status == IdentificationStatus::kRefused)
    throw refusalOf(first.fit.reading_problem, first.fit.reason, input);
  if (!isUsable(first.fit)) {
    result.end = ImprovementEnd::kNotFitted;
    result.models.push_back(std::move(first));
    return result;
  }
  keep(request, std::move(first), result);
  for (int round = 1; round <= request.steps; ++round)
    if (!improveOnce(input, request, within(hooks, fmt::format("diagnosis {}", round)), result)) return result;
  result.end = ImprovementEnd::kMostSteps;
  return result;
}

const char* nameOf(ImprovementEnd end) {
  switch (end) {
    case ImprovementEnd::kNotRun:
      return "not-run";
    case ImprovementEnd::kAdequate:
      return "adequate";
    case ImprovementEnd::kNothingSure:
      return "nothing-sure";
    case ImprovementEnd::kAmbiguous:
      return "ambiguous";
    case ImprovementEnd::kDoesNotCarryOver:
      return "does-not-carry-over";
    case ImprovementEnd::kMistake:
      return "mistake";
    case ImprovementEnd::kInconclusive:
      return "inconclusive";
    case ImprovementEnd::kMostSteps:
      return "most-steps";
    case ImprovementEnd::kNotFitted:
      return "not-fitted";
  }
  return "";
}

std::vector<ModelComparisonRow> comparisonRowsOf(const Improvement& result) {
  std::vector<ModelComparisonRow> comparison;
  for (const auto& model : result.models) comparison.push_back(comparisonRowOf(model.name, model.fit));
  return comparison;
}

nlohmann::json improvementJson(const Improvement& result, const Units& units) {
  const auto pair = [&](const calibration::ErrorSize& before, const calibration::ErrorSize& after) {
    return nlohmann::json{{"before", lengthJson(before.rms, units)}, {"after", lengthJson(after.rms, units)}};
  };
  nlohmann::json json = modelComparisonJson(comparisonRowsOf(result), units);
  json["end"] = nameOf(result.end);
  json["steps"] = nlohmann::json::array();
  for (const auto& step : result.steps)
    json["steps"].push_back({{"verdict", nameOf(step.verdict)},
                             {"sentence", step.sentence},
                             {"added", step.added},
                             {"also", step.also},
                             {"reason", step.reason},
                             {"heldout_rms", pair(step.heldout_before, step.heldout_after)},
                             {"farthest_rms", pair(step.farthest_before, step.farthest_after)}});
  return json;
}

}  // namespace tubeplan::app
