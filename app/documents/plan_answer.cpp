#include "app/documents/plan_answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/storage/count_text.hpp"

namespace tubeplan::app {

namespace {

std::vector<int> roundedCounts(const std::vector<double>& counts) {
  std::vector<int> rounded;
  for (const double count : counts) rounded.push_back(static_cast<int>(std::lround(count)));
  return rounded;
}

/// Returns, for the true arm and the plan's compensation, the numbers of tubes in which 0, 1, ... steps enter; empty
/// without a true arm.
std::vector<int> trueCounts(const PlanOutcome& outcome) {
  if (outcome.scores.empty()) return {};
  const auto mode = std::ranges::find(kCompensations, outcome.compensation) - kCompensations.begin();
  return countByMode(outcome.scores, static_cast<int>(outcome.model.tool.steps.size()))[static_cast<std::size_t>(mode)];
}

/// Returns a string such as "2 steps in 41 tubes, 3 steps in 18 tubes".
std::string tubesByStepsText(const std::vector<int>& counts) {
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < counts.size(); ++k)
    if (counts[k] > 0)
      parts.push_back((k == 0 ? "no steps" : countText(k, "step")) + " in " +
                      countText(static_cast<std::size_t>(counts[k]), "tube"));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string plannedStepsText(const PlanOutcome& outcome) {
  std::string text = "the insertion of the tool is not known";
  if (!outcome.chances.by_posture.empty())
    text = "expected of the tool: " + tubesByStepsText(roundedCounts(expectedCounts(outcome.chances)));
  if (const auto counts = trueCounts(outcome); !counts.empty())
    text += "; by the true arm: " + tubesByStepsText(counts);
  return text;
}

}  // namespace

std::string planAnswer(const PlanOutcome& outcome) {
  const std::size_t visited = outcome.plan.visits.size(), tubes = visited + outcome.plan.unreachable.size();
  return fmt::format("{} of {} tubes are visited; {}; the path is proved free {}.", visited, tubes,
                     plannedStepsText(outcome), wordsOf(outcome.standing()));
}

}  // namespace tubeplan::app
