#include "app/documents/plan_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/documents/calibration_json.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/plan_files.hpp"
#include "app/documents/step_chances_json.hpp"
#include "app/formats/units.hpp"

namespace tubeplan::app {

double minClearance(const PlanOutcome& outcome) { return outcome.plan.min_margin + outcome.model.scene.clearance; }

std::string tightestText(const PlanOutcome& outcome) {
  const auto& tightest = outcome.plan.tightest;
  return tightest.body.empty() ? tightest.other : tightest.body + " to " + tightest.other;
}

std::string reusedText(const PlanOutcome& outcome) {
  const auto& plan = outcome.plan;
  const auto isTravel = [](const auto& segment) { return segment.kind == planner::SegmentKind::kTravel; };
  const auto isProved = [](const auto& segment) {
    return segment.kind != planner::SegmentKind::kRetreat || segment.visit < 0;
  };
  return fmt::format("the reach of {} of {} tubes, {} of {} travels, {} of {} proofs{}{}", plan.kept.reach,
                     plan.visits.size() + plan.unreachable.size(), plan.kept.travels,
                     std::ranges::count_if(plan.segments, isTravel), plan.kept.proofs,
                     std::ranges::count_if(plan.segments, isProved), plan.kept.order ? ", the order" : "",
                     plan.kept.bound ? ", the bound" : "");
}

namespace {

constexpr std::size_t kUnreachableShown = 5;

constexpr TextLine kPlanWords[] = {
    {"warnings", "warning: {}\n"},
    {"",
     "tubes {#tubes} planned, {#unreachable} unreachable; model tip within {worst:.1e units/length} of each centre, "
     "tilt "
     "at most {tilt:.2f units/angle}\n"},
    {"left_out", "  {} left out: such tubes are planned only by state (--tubes all,plugged) or by name\n"},
    {"unreachable", "  R{row}C{column} {reason}\n", {}, {}, kUnreachableShown},
    {"more_unreachable", "  and {} more, each with its reason in plan.json\n"},
    {"",
     "travel {travel_time_s:.1f} s (lower bound {lower_bound_s:.1f} s, gap {gap:.2%} %; row by row "
     "{row_by_row_time_s:.1f} s); {total_time_s:.1f} s in total, {detours} detours\n"},
    {"travel/on_line", "{} travels with the tip on a straight line, within {line_deviation:.4r units/length} of it\n"},
    {"min_clearance", "clearance at least {:.4r units/length} ({clearance_required:.4r units/length} asked for"},
    {"+padding/added",
     ", beyond the padding for the uncertainty of {padding/covers}: up to {:.4r units/length} at the tip"},
    {"min_clearance", "), tightest {tightest}; proved {base/words}\n"},
    {"least_play",
     "{insertion:.4r units/length} past the face; the tool's play in a tube at least {:.4r units/length}\n"}};

constexpr TextLine kMissedWords[] = {{"missed", "   ({} out of this model's reach)"}, {"", "\n"}};
constexpr TextLine kPlanStepWords[] = {
    {"", "tubes by number of inserted steps of the calibration tool, from none\n  {base/words}\n"},
    {"probabilities/expected_counts", "  {@:<40}{expected_counts:*8.1f}\n", {}, "predicted, on average", 1},
    {"by_true_arm", "  by the true arm, {mode:<23}{counts:*8}", kMissedWords}};

double largest(const nlohmann::json& tubes, const char* key) {
  double most = 0;
  for (const auto& tube : tubes) most = std::max(most, tube[key].get<double>());
  return most;
}

/// Returns the JSON of the plan with additional entries that only the text uses.
nlohmann::json shownPlan(const PlanRequest& request, const PlanOutcome& outcome) {
  nlohmann::json plan = planJson(request, outcome);
  plan["worst"] = largest(plan["tubes"], "centring_error");
  plan["tilt"] = largest(plan["tubes"], "tilt");
  const std::size_t missed = plan["unreachable"].size();
  plan["more_unreachable"] = missed - std::min(missed, kUnreachableShown);
  if (!outcome.play.empty()) plan["least_play"] = lengthOf(std::ranges::min(outcome.play), outcome.cell.units);
  if (plan["counts"].is_null()) return plan;
  for (const auto& mode : plan["modes"]) {
    const auto& counts = plan["counts"][mode["name"].get<std::string>()];
    auto missed_by = static_cast<int>(outcome.scores.size());
    for (const int scored : counts) missed_by -= scored;
    plan["by_true_arm"].push_back(
        {{"mode", mode["brief"].get<std::string>() + " compensation"}, {"counts", counts}, {"missed", missed_by}});
  }
  return plan;
}

}  // namespace

std::string planText(const PlanRequest& request, const PlanOutcome& outcome) {
  const nlohmann::json plan = shownPlan(request, outcome);
  std::string text = textOf(plan, "{sentence}\n");
  if (outcome.calibration) text += calibrationText(outcome.calibration->flexible, outcome.cell, false);
  text += textOf(plan, kPlanWords) + stepChancesText(outcome.chances, outcome.cell.units);
  return outcome.scores.empty() && outcome.chances.by_posture.empty() ? text : text + textOf(plan, kPlanStepWords);
}

}  // namespace tubeplan::app
