// Planning: reach, fields, postures under a hole, the plan and the path to play.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/command_inputs.hpp"
#include "app/input_error.hpp"
#include "app/plan_files.hpp"
#include "app/workbench/job_routes.hpp"
#include "app/workbench/posture_answer.hpp"
#include "app/workbench/reach_jobs.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/request_numbers.hpp"
#include "app/workbench/routes.hpp"
#include "app/workcell.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

constexpr double kMostSamples = 20000;

Answer reach(Workbench& workbench, const Request& request) {
  (void)objectOf(request);
  (void)workcellOf(currentModel(workbench.situation()).cell, "reach its holes");
  return beginJob(workbench, "reach", "which holes the arm reaches", [&workbench](JobContext& context) {
    const Situation began = workbench.situation();
    const json figures = reachOfAll(currentModel(began).cell, context);
    finishJob(workbench, began,
              [&](Situation& situation) { putResult(situation, "reach", currentModel(began).id, figures); });
    return "reach";
  });
}

Answer field(Workbench& workbench, const Request& request) {
  const std::string of = textOf(objectOf(request), "of", "centring");
  requireField(of);
  (void)workcellOf(currentModel(workbench.situation()).cell, "look at its holes");
  return beginJob(workbench, "field", of + " over the sheet", [&workbench, of](JobContext& context) {
    const Situation began = workbench.situation();
    const json figures = fieldOf(began, of, context);
    finishJob(workbench, began,
              [&](Situation& situation) { putResult(situation, "field", currentModel(began).id, figures); });
    return "field";
  });
}

json branchJson(const planner::TubeBranch& branch, const Model& model, double load) {
  const Units& units = model.cell.units;
  const bool is_found = branch.status == deflection::BranchStatus::kConverged;
  return {{"status", is_found ? "found" : "not-found"},
          {"reason", branch.reason},
          {"joints", jointValuesJson(branch.q, model.cell)},
          {"predicted_tip", vectorJson(branch.predicted_tip_W, units, dimension::kLength)},
          {"tilt", angleOf(branch.tilt, units)},
          {"clearance", is_found ? clearanceOf(model, branch.q, load) : json()}};
}

/// Most of the branches that are found and clear come first.
Answer inverse(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const Situation now = workbench.situation();
  const Model& model = currentModel(now);
  const int hole = requiredHoleOf(body, model.cell);
  const int wanted = integerOf(body, "branch", -1, -1, 100);
  auto work = workcellOf(model.cell, "find postures under a hole");
  work.load = loadOf(body, model.cell);
  planner::CompensationOptions options;
  options.with_approach = false;
  json branches = json::array();
  for (const auto& branch :
       planner::compensate(work, planner::holeCentre(work.sheet.tubes[static_cast<std::size_t>(hole)]), options))
    if (branch.q.size() > 0) branches.push_back(branchJson(branch, model, work.load));
  const auto margin = [](const json& branch) {
    if (branch["status"] != "found") return -2e300;
    return branch["clearance"].is_object() ? branch["clearance"]["margin"].get<double>() : -1e300;
  };
  int chosen = wanted;
  if (wanted < 0 && !branches.empty())
    chosen = static_cast<int>(std::max_element(branches.begin(), branches.end(),
                                               [&](const json& a, const json& b) { return margin(a) < margin(b); }) -
                              branches.begin());
  const bool is_there = chosen >= 0 && chosen < static_cast<int>(branches.size());
  json answer = {{"hole", hole}, {"units", unitsJson(model.cell.units)}, {"branches", branches}, {"branch", chosen}};
  answer["status"] = is_there ? branches[static_cast<std::size_t>(chosen)]["status"] : json("out-of-reach");
  answer["joints"] = is_there ? branches[static_cast<std::size_t>(chosen)]["joints"] : json();
  answer["predicted_tip"] = is_there ? branches[static_cast<std::size_t>(chosen)]["predicted_tip"] : json();
  return answerOf(answer);
}

/// Throws what tells why there is no plan.
void requirePlanned(const PlanOutcome& outcome) {
  if (outcome.plan.status == planner::VisitPlanStatus::kStopped) throw JobStopped{};
  if (outcome.plan.status == planner::VisitPlanStatus::kPlanned) return;
  const std::string first = outcome.plan.unreachable.empty() ? "" : ": " + outcome.plan.unreachable.front().reason;
  throw InputError("tubes", outcome.plan.reason + first, "tubes that the arm can visit");
}

Answer plan(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const Situation now = workbench.situation();
  const Cell& cell = currentModel(now).cell;
  PlanRequest asked;
  asked.tubes = tubesText(body, requireSheet(cell, "plan tube visits"), "spread:60");
  asked.compensation = textOf(body, "compensation", asked.compensation);
  if (!planner::findCompensation(asked.compensation))
    throw InputError("request (compensation)", inQuotes(asked.compensation), "none, goal-point or via-point");
  asked.load = numberOf(body, "load", 0);
  (void)parseLoad(asked.load, cell.units);
  asked.seed = seedOf(body);
  return beginJob(workbench, "plan", "a proved visit of the tubes", [&workbench, asked](JobContext& context) mutable {
    const Situation began = workbench.situation();
    asked.truth = began.truth;
    asked.cell = currentModel(began).cell.path;
    auto outcome = std::make_shared<PlanOutcome>(planCell(currentModel(began).cell, asked, planHooksOf(context)));
    requirePlanned(*outcome);
    const json figures = planJson(asked, *outcome);
    finishJob(workbench, began, [&](Situation& situation) {
      situation.plan = outcome;
      situation.plan_request = asked;
      putResult(situation, "plan", currentModel(began).id, figures);
    });
    return "plan";
  });
}

double forPlaying(double value) { return std::round(value * 1e6) / 1e6; }

/// The clearance that is proved of a segment, null where it has none.
json clearanceOfSegment(const PlanOutcome& outcome, int segment) {
  const double margin = outcome.plan.segments[static_cast<std::size_t>(segment)].margin;
  if (!std::isfinite(margin)) return nullptr;
  return forPlaying(lengthOf(margin + outcome.model.scene.clearance, outcome.cell.units));
}

Answer path(Workbench& workbench, const Request&) {
  const Situation now = workbench.situation();
  if (!now.plan) return refusal(404, InputError("plan", "none yet", "one that was made"));
  const PlanOutcome& outcome = *now.plan;
  const Eigen::VectorXd factors = jointFactors(outcome.cell.arm, outcome.cell.units);
  const double step = std::max(0.25, outcome.plan.total_time / kMostSamples);
  json time = json::array(), segment = json::array(), kind = json::array(), joints = json::array(),
       clearance = json::array(), tube = json::array();
  for (const auto& row : planner::samplePath(outcome.plan, planner::jointSpeedsOf(outcome.model.arm), step)) {
    time.push_back(forPlaying(row.time));
    segment.push_back(row.segment);
    kind.push_back(planner::nameOf(row.kind));
    json q = json::array();
    for (const double value : row.q.cwiseQuotient(factors)) q.push_back(forPlaying(value));
    joints.push_back(std::move(q));
    tube.push_back(outcome.plan.segments[static_cast<std::size_t>(row.segment)].visit);
  }
  for (std::size_t k = 0; k < outcome.plan.segments.size(); ++k)
    clearance.push_back(clearanceOfSegment(outcome, static_cast<int>(k)));
  return answerOf({{"units", unitsJson(outcome.cell.units)},
                   {"time", time},
                   {"segment", segment},
                   {"kind", kind},
                   {"joints", joints},
                   {"tube", tube},
                   {"clearance", clearance}});
}

constexpr Route kRoutes[] = {
    {"POST", "reach", reach}, {"POST", "field", field},   {"POST", "inverse", inverse},
    {"POST", "plan", plan},   {"GET", "plan/path", path},
};

}  // namespace

std::span<const Route> planRoutes() { return kRoutes; }

}  // namespace tubeplan::app
