#include "app/documents/improvement_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/documents/diagnosis_json.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/model_comparison_json.hpp"

namespace tubeplan::app {

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

std::string sentenceOf(const ImprovementStep& step, const Units& units) {
  return step.reason == ImprovementReason::kMistakeExplains ? step.diagnosis.reason
                                                            : diagnosisSentence(step.diagnosis, units);
}

std::string reasonText(const ImprovementStep& step, const Units& units) {
  const std::string first = lengthText(step.first, units), second = lengthText(step.second, units);
  switch (step.reason) {
    case ImprovementReason::kNothingMissing:
      return "nothing is missing";
    case ImprovementReason::kScatter:
      return fmt::format("what is left, {} beyond the stated noise, follows nothing that the readings state", first);
    case ImprovementReason::kSure:
      return "sure, and it predicts the farthest poses";
    case ImprovementReason::kSureInAll:
      return "sure in every alternative, and it predicts the farthest poses";
    case ImprovementReason::kAlternativesClose:
      return fmt::format(
          "the alternatives differ by {} over the arm's range, less than the {} that is gained; this "
          "one is the most probable of those that predict the farthest poses well",
          first, second);
    case ImprovementReason::kAlternativesApart:
      return fmt::format(
          "the alternatives differ by {} over the arm's range, more than the {} that is gained: take "
          "the readings that `diagnose` proposes, which separate them",
          first, second);
    case ImprovementReason::kUnsureButLower:
      return "not sure, but it lowers the error of readings kept out and of the farthest poses";
    case ImprovementReason::kNoneLower:
      return "no cause is sure, and none lowers the error of readings kept out and of the farthest poses by 5 %";
    case ImprovementReason::kFarthestWorse:
      return fmt::format(
          "by a fit to the nearer poses it makes the farthest worse, {} from {}: readings there are needed", first,
          second);
    case ImprovementReason::kNotLowerTogether:
      return "fitted with everything else it does not lower the error of readings kept out: it is left out";
    case ImprovementReason::kMistakeExplains:
      return "a mistake with the readings explains the error: nothing is added to the model";
    case ImprovementReason::kNoVerdict:
      return step.diagnosis.reason.empty() ? "the readings hint at something missing, but not at what"
                                           : step.diagnosis.reason;
  }
  return "";
}

nlohmann::json improvementJson(const Improvement& result, const Units& units) {
  const auto pair = [&](const calibration::ErrorSize& before, const calibration::ErrorSize& after) {
    return nlohmann::json{{"before", lengthJson(before.rms, units)}, {"after", lengthJson(after.rms, units)}};
  };
  nlohmann::json json = modelComparisonJson(comparisonRowsOf(result), units);
  json["end"] = nameOf(result.end);
  json["steps"] = nlohmann::json::array();
  for (const auto& step : result.steps)
    json["steps"].push_back({{"verdict", nameOf(step.diagnosis.verdict)},
                             {"sentence", sentenceOf(step, units)},
                             {"added", step.added},
                             {"also", step.also},
                             {"reason", reasonText(step, units)},
                             {"heldout_rms", pair(step.heldout_before, step.heldout_after)},
                             {"farthest_rms", pair(step.farthest_before, step.farthest_after)}});
  return json;
}

}  // namespace tubeplan::app
