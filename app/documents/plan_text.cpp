#include "app/documents/plan_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/documents/calibration_json.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/plan_answer.hpp"
#include "app/documents/step_chances_json.hpp"
#include "app/files/units.hpp"

namespace tubeplan::app {

double minClearance(const PlanOutcome& outcome) { return outcome.plan.min_margin + outcome.model.scene.clearance; }

std::string tightestText(const PlanOutcome& outcome) {
  const auto& tightest = outcome.plan.tightest;
  return tightest.body.empty() ? tightest.other : tightest.body + " to " + tightest.other;
}

namespace {

std::string stepsHeading(const PlanOutcome& outcome) {
  std::string text = fmt::format("{:<58}", "tubes by number of inserted steps of the calibration tool");
  for (std::size_t k = 0; k <= outcome.model.tool.steps.size(); ++k) text += fmt::format(" {:7}", k);
  return text + "\n  " + wordsOf(outcome.standing()) + "\n";
}

std::string expectedText(const PlanOutcome& outcome) {
  if (outcome.chances.by_posture.empty()) return "";
  std::string text = fmt::format("  {:<56}", "as predicted, on the average");
  for (const double count : expectedCounts(outcome.chances)) text += fmt::format(" {:7.1f}", count);
  return text + "\n";
}

std::string plannedModelText(const PlanOutcome& outcome) {
  std::string text;
  if (outcome.calibration) text += calibrationText(outcome.calibration->flexible, outcome.cell, false);
  for (const auto& warning : outcome.cell.warnings) text += "warning: " + warning + "\n";
  return text;
}

std::string plannedTubesText(const PlanOutcome& outcome) {
  constexpr std::size_t kShown = 5;
  const auto& plan = outcome.plan;
  const Units& units = outcome.cell.units;
  double worst = 0, tilt = 0;
  for (std::size_t k = 0; k < plan.visits.size(); ++k) {
    worst = std::max(worst, outcome.predicted[k].error);
    tilt = std::max(tilt, plan.visits[k].branch.tilt);
  }
  std::string text = fmt::format(
      "tubes {} planned, {} unreachable; model tip within {:.1e} {} of each centre, tilt at most {:.2f} {}\n",
      plan.visits.size(), plan.unreachable.size(), worst / units.factor(dimension::kLength), units.length().name,
      tilt / units.factor(dimension::kAngle), units.angle().name);
  if (!outcome.left_out.empty())
    text += fmt::format("  {} left out: such tubes are planned by state (--tubes all,plugged) or by name alone\n",
                        outcome.left_out);
  for (std::size_t k = 0; k < std::min(plan.unreachable.size(), kShown); ++k) {
    const auto& tube = outcome.model.sheet.tubes[static_cast<std::size_t>(plan.unreachable[k].tube)];
    text += fmt::format("  {} {}\n", tubesheets::tubeName(tube.row, tube.column), plan.unreachable[k].reason);
  }
  if (plan.unreachable.size() > kShown)
    text += fmt::format("  and {} more, each with its reason in plan.json\n", plan.unreachable.size() - kShown);
  return text;
}

std::string plannedWayText(const PlanOutcome& outcome) {
  const auto& plan = outcome.plan;
  const Units& units = outcome.cell.units;
  std::string text = fmt::format(
      "travel {:.1f} s (lower bound {:.1f} s, gap {:.2f} %; row by row {:.1f} s); {:.1f} s in total, {} detours\n",
      plan.travel_time, plan.lower_bound, 100 * plan.optimality_gap, plan.row_by_row_time, plan.total_time,
      plan.detours);
  if (plan.lines > 0)
    text += fmt::format("{} travels with the tip on a straight line, within {} of it\n", plan.lines,
                        lengthText(plan.line_deviation, units));
  if (std::isfinite(minClearance(outcome)))
    text += fmt::format("clearance at least {} ({} asked for{}), tightest {}; proved {}\n",
                        lengthText(minClearance(outcome), units), lengthText(outcome.model.scene.clearance, units),
                        outcome.padding > 0
                            ? fmt::format(", beyond what the base may be off, not the arm's numbers: {} at a tip",
                                          lengthText(outcome.padding, units))
                            : "",
                        tightestText(outcome), wordsOf(outcome.standing()));
  if (!outcome.play.empty())
    text += fmt::format("{} past the face; the tool's play in a tube at least {}\n",
                        lengthText(outcome.model.insertion, units), lengthText(std::ranges::min(outcome.play), units));
  return text;
}

std::string trueStepsText(const PlanOutcome& outcome) {
  const auto counts = countByMode(outcome.scores, static_cast<int>(outcome.model.tool.steps.size()));
  std::string text;
  for (std::size_t mode = 0; mode < kCompensations.size(); ++mode) {
    text += fmt::format("  {:<56}",
                        "by the true arm, " + std::string(planner::nameOf(kCompensations[mode])) + " compensation");
    int scored = 0;
    for (int count : counts[mode]) {
      text += fmt::format(" {:7}", count);
      scored += count;
    }
    const int missed = static_cast<int>(outcome.scores.size()) - scored;
    text += missed ? fmt::format("   ({} out of this model's reach)\n", missed) : "\n";
  }
  return text;
}

}  // namespace

std::string planText(const PlanOutcome& outcome) {
  std::string text =
      planAnswer(outcome) + "\n" + plannedModelText(outcome) + plannedTubesText(outcome) + plannedWayText(outcome);
  text += stepChancesText(outcome.chances, outcome.cell.units);
  if (outcome.scores.empty() && outcome.chances.by_posture.empty()) return text;
  text += stepsHeading(outcome) + expectedText(outcome);
  return outcome.scores.empty() ? text : text + trueStepsText(outcome);
}

}  // namespace tubeplan::app
