#include "app/documents/improvement_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/documents/diagnosis_text.hpp"
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
      return fmt::format("the remainder, {} beyond the stated noise, {}", first, kFollowsNothing);
    case ImprovementReason::kSure:
      return "certain, and it predicts the farthest poses";
    case ImprovementReason::kSureInAll:
      return "part of every alternative, and it predicts the farthest poses";
    case ImprovementReason::kAlternativesClose:
      return fmt::format(
          "the alternatives differ by {} over the arm's range, less than the {} that is gained; this "
          "one is the most probable of those that predict the farthest poses well",
          first, second);
    case ImprovementReason::kAlternativesApart:
      return fmt::format(
          "the alternatives differ by {} over the arm's range, more than the {} that is gained: take the readings that "
          "`diagnose` proposes, which discriminate between them",
          first, second);
    case ImprovementReason::kUnsureButLower:
      return "not certain, but it lowers the error of held-out readings and of the farthest poses";
    case ImprovementReason::kNoneLower:
      return "no cause is certain, and none lowers the error of held-out readings and of the farthest poses by 5 %";
    case ImprovementReason::kFarthestWorse:
      return fmt::format(
          "fitted to the nearer poses it extrapolates worse to the farthest, {} from {}: readings there are needed",
          first, second);
    case ImprovementReason::kNotLowerTogether:
      return "fitted with everything else it does not lower the held-out error: it is not added";
    case ImprovementReason::kMistakeExplains:
      return "a mistake with the readings explains the error: nothing is added to the model";
    case ImprovementReason::kNoVerdict:
      return step.diagnosis.reason.empty() ? "the readings suggest that something is missing, but not what"
                                           : step.diagnosis.reason;
  }
  return "";
}

std::vector<std::string> idsSetAside(const Improvement& result, const std::vector<calibration::Measurement>& readings) {
  return result.models.empty() ? std::vector<std::string>() : idsOf(result.models.back().set_aside, readings);
}

nlohmann::json improvementJson(const Improvement& result, const std::vector<calibration::Measurement>& readings,
                               const Units& units) {
  const auto pair = [&](const calibration::ErrorSize& before, const calibration::ErrorSize& after) {
    return nlohmann::json{{"before", lengthJson(before.rms, units)}, {"after", lengthJson(after.rms, units)}};
  };
  nlohmann::json json = modelComparisonJson(comparisonRowsOf(result), units);
  json["end"] = nameOf(result.end);
  json["set_aside"] = idsSetAside(result, readings);
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
