#include "app/documents/improvement_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/documents/diagnosis_sentences.hpp"
#include "app/documents/error_figures.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/documents/model_comparison_json.hpp"

namespace tubeplan::app {

namespace {

/// Reason for the end of the loop: its name in JSON, and a clause that ends a sentence.
struct EndRow {
  ImprovementEnd end;
  const char *name, *words;
};

constexpr EndRow kEnds[] = {
    {ImprovementEnd::kNotRun, "not-run", "the model was not improved"},
    {ImprovementEnd::kAdequate, "adequate", "nothing more is missing"},
    {ImprovementEnd::kNothingCertain, "nothing-sure", "no known effect is certain to explain the remainder"},
    {ImprovementEnd::kAmbiguous, "ambiguous",
     "several effects explain the remainder, and these readings cannot distinguish them"},
    {ImprovementEnd::kDoesNotCarryOver, "does-not-carry-over",
     "no further effect improves the prediction of held-out readings"},
    {ImprovementEnd::kMistake, "mistake", "a mistake in the readings is suspected and must be corrected first"},
    {ImprovementEnd::kInconclusive, "inconclusive", "these readings allow no verdict on the remainder"},
    {ImprovementEnd::kMostSteps, "most-steps", "the requested number of steps is reached, and more may be missing"},
    {ImprovementEnd::kNotFitted, "not-fitted", "the model as given cannot be fitted"}};

const EndRow& rowOf(ImprovementEnd end) { return *std::ranges::find(kEnds, end, &EndRow::end); }

/// Returns a sentence on the diagnosis of a step.
std::string sentenceOf(const ImprovementStep& step, const Units& units) {
  return step.reason == ImprovementReason::kMistakeExplains ? step.diagnosis.reason
                                                            : diagnosisSentence(step.diagnosis, units);
}

/// Returns the ids of the measurements that the last model's fit leaves out as outliers.
std::vector<std::string> idsSetAside(const Improvement& result,
                                     const std::vector<calibration::Measurement>& measurements) {
  return result.models.empty() ? std::vector<std::string>() : idsOf(result.models.back().set_aside, measurements);
}

/// Returns one sentence on the added causes, the held-out errors and the reason for the end.
std::string improvementSentence(const Improvement& result, const Units& units) {
  std::vector<std::string> added;
  for (const auto& step : result.steps) added.insert(added.end(), step.added.begin(), step.added.end());
  const std::string what = added.empty() ? "Nothing was added" : fmt::format("Added {}", fmt::join(added, ", "));
  if (result.models.empty()) return fmt::format("{}: {}.", what, rowOf(result.end).words);
  const auto &first = result.models.front().fit, &last = result.models.back().fit;
  const ErrorUnit unit = errorUnitOf(last.after.are_angles, units);
  const auto text = [&](double error) { return errorText(error, unit, 3); };
  const std::string error = added.empty() ? fmt::format("the held-out error is {}", text(last.heldout.rms))
                                          : fmt::format("the held-out error {} from {} to {}",
                                                        last.heldout.rms < first.heldout.rms ? "fell" : "rose",
                                                        text(first.heldout.rms), text(last.heldout.rms));
  return fmt::format("{}; {} (noise floor {}): {}.", what, error, text(last.noise_floor), rowOf(result.end).words);
}

constexpr TextLine kImprovementStepWords[] = {
    {"added", "  added {added}: {reason}\n", {}, {}, 1},
    {"!added", "  ended ({end}): {reason}\n"},
    {"not_needed",
     "  without {not_needed}: their fitted sizes are within three standard deviations of zero, and held-out readings "
     "are predicted as well\n",
     {},
     {},
     1},
    {"also", "  no reading with this tool can distinguish it from: {also}\n", {}, {}, 1}};

constexpr TextLine kImprovementWords[] = {{"", "{sentence}\n"},
                                          {"steps", "step {number}: {verdict}: {sentence}\n", kImprovementStepWords},
                                          {"set_aside", kSetAsideWords, {}, {}, 1}};

}  // namespace

const char* nameOf(ImprovementEnd end) { return rowOf(end).name; }

std::string reasonText(const ImprovementStep& step, const Units& units) {
  const ErrorUnit unit = errorUnitOf(step.diagnosis.before.are_angles, units);
  const std::string first = errorText(step.first, unit), second = errorText(step.second, unit);
  switch (step.reason) {
    case ImprovementReason::kNothingMissing:
      return "nothing is missing";
    case ImprovementReason::kScatter:
      return fmt::format("the remainder, {} beyond the stated noise, {}",
                         errorText(budgetOf(step.diagnosis).remainder, unit), kFollowsNothing);
    case ImprovementReason::kCertain:
      return "certain, and it predicts the farthest poses";
    case ImprovementReason::kCertainInAll:
      return "part of every alternative, and it predicts the farthest poses";
    case ImprovementReason::kAlternativesClose:
      return fmt::format(
          "the alternatives differ by {} over the arm's range, less than the {} that is gained; this "
          "one is the most probable of those that predict the farthest poses well",
          first, second);
    case ImprovementReason::kAlternativesDiffer:
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
          "a fit to the nearer poses predicts the farthest poses worse, {} from {}: readings there are needed", first,
          second);
    case ImprovementReason::kNotLowerTogether:
      return "if it is fitted together with everything else, the held-out error does not fall: it is not added";
    case ImprovementReason::kMistakeExplains:
      return "a mistake in the readings explains the error: nothing is added to the model";
    case ImprovementReason::kNoVerdict:
      return step.diagnosis.reason.empty() ? "the readings suggest that something is missing, but not what"
                                           : step.diagnosis.reason;
  }
  return "";
}

nlohmann::json improvementJson(const Improvement& result, const std::vector<calibration::Measurement>& measurements,
                               const Units& units) {
  const auto pair = [&](const calibration::ErrorSize& before, const calibration::ErrorSize& after) {
    const ErrorUnit unit = errorUnitOf(before.are_angles, units);
    return nlohmann::json{{"before", errorJson(before.rms, unit)}, {"after", errorJson(after.rms, unit)}};
  };
  nlohmann::json json = modelComparisonJson(comparisonRowsOf(result), idsSetAside(result, measurements).size(), units);
  json["sentence"] = improvementSentence(result, units);
  json["end"] = nameOf(result.end);
  json["set_aside"] = idsSetAside(result, measurements);
  json["steps"] = nlohmann::json::array();
  for (const auto& step : result.steps)
    json["steps"].push_back({{"verdict", nameOf(step.diagnosis.verdict)},
                             {"sentence", sentenceOf(step, units)},
                             {"added", step.added},
                             {"also", step.indistinguishable},
                             {"not_needed", step.not_needed},
                             {"reason", reasonText(step, units)},
                             {"heldout_rms", pair(step.heldout_before, step.heldout_after)},
                             {"farthest_rms", pair(step.farthest_before, step.farthest_after)}});
  return json;
}

std::string improvementText(nlohmann::json figures) {
  int number = 0;
  for (auto& step : figures["steps"]) step["number"] = ++number;
  return textOf(figures, kImprovementWords) + (figures["models"].empty() ? "" : modelComparisonText(figures));
}

}  // namespace tubeplan::app
