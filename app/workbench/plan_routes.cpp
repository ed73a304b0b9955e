// Planning routes: reach, fields, postures under a hole, work lists, the plan and its path.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/documents/figures.hpp"
#include "app/documents/plan_files.hpp"
#include "app/documents/pose_json.hpp"
#include "app/documents/tube_columns_json.hpp"
#include "app/formats/cell/command_inputs.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/formats/other_file.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"
#include "app/jobs/plan.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/text_file.hpp"
#include "app/workbench/job_routes.hpp"
#include "app/workbench/path_answer.hpp"
#include "app/workbench/posture_answer.hpp"
#include "app/workbench/reach_jobs.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

Answer reach(Workbench& workbench, const Request& request) {
  (void)objectOf(request);
  (void)workcellOf(currentModel(workbench.session()).cell, "reach its holes");
  return beginResultJob(
      workbench, "reach", "Reachable holes", JobInput::kModel,
      [](const Session& began, JobContext& context) { return reachOfAll(currentModel(began).cell, context); });
}

/// Returns the session with model `id` as its current model. Throws InputError for an unknown id.
Session atModel(Session session, int id) {
  const auto at = findModel(session, id);
  if (!at) throw InputError("request (model)", std::to_string(id), "the number of a model");
  session.current = *at;
  return session;
}

/// Begins the computation of a field (one value for each hole), for the request {"of", "model"?}; the default is the
/// current model.
Answer field(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const std::string of = textOf(body, "of", "centring");
  requireField(of);
  (void)workcellOf(currentModel(workbench.session()).cell, "show its holes");
  const int model = integerOf(body, "model", currentModel(workbench.session()).id, 0, std::numeric_limits<int>::max());
  (void)atModel(workbench.session(), model);  // refuse an unknown model before the job begins
  return beginJob(workbench, "field", of + " over the sheet", [=, &workbench](JobContext& context) {
    const Session began = workbench.session();
    const auto document = fieldOf(atModel(began, model), of, context);
    finishJob(workbench, began, JobInput::kModel,
              [&](Session& session) { putResult(session, "field", model, document); });
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

/// Finds the postures under a hole, for the request {"hole", "branch"?, "load"?}. Without "branch", the posture with
/// the largest clearance margin is chosen.
Answer inverse(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const Session now = workbench.session();
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

/// Throws InputError for the name of a file, because a request may select tubes only by their names.
void requireNoFile(const std::string& tubes) {
  if (tubes.ends_with(".csv"))
    throw InputError::problem("request (first)",
                              inQuotes(tubes) + " is the name of a file, but a request cannot name files",
                              "select the tubes by name, such as R10C20 or outer:2");
}

Answer plan(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const Session now = workbench.session();
  const Cell& cell = currentModel(now).cell;
  PlanRequest plan_request;
  const auto& sheet = requireSheet(cell, "plan tube visits");
  plan_request.tubes = tubesText(body, sheet, tubesheets::spreadRequest(sheet, 60));
  plan_request.dwell_times = dwellTimesOf(body, sheet);
  plan_request.compensation = textOf(body, "compensation", plan_request.compensation);
  if (!planner::findCompensation(plan_request.compensation))
    throw InputError("request (compensation)", inQuotes(plan_request.compensation), "none, goal-point or via-point");
  plan_request.travel = textOf(body, "travel", plan_request.travel);
  plan_request.load = numberOf(body, "load", 0);
  (void)parseLoad(plan_request.load, cell.units, "request (load)");
  plan_request.seed = seedOf(body);
  plan_request.conditions = {textOf(body, "start"), textOf(body, "end"), {}, numberOf(body, "dwell", 0)};
  plan_request.padding = numberOf(body, "padding", 0);
  plan_request.insertion = numberOf(body, "insertion", 0);
  if (body.contains("standoff") && !body["standoff"].is_null()) plan_request.standoff = numberOf(body, "standoff", 0);
  plan_request.has_least_standoff = booleanOf(body, "least_standoff", false);
  if (body.contains("first"))
    for (const auto& zone : textsOf(body, "first")) {
      requireNoFile(zone);
      plan_request.conditions.first.push_back(zone);
    }
  (void)conditionsOf(plan_request.conditions, cell, {});
  return beginJob(workbench, "plan", "Plan", [&workbench, plan_request](JobContext& context) mutable {
    const Session began = workbench.session();
    plan_request.truth = began.truth;
    plan_request.cell = currentModel(began).cell.path;
    auto outcome =
        std::make_shared<PlanOutcome>(planCell(currentModel(began).cell, plan_request, planHooksOf(context)));
    requirePlanned(*outcome);
    const json figures = planJson(plan_request, *outcome);
    finishJob(workbench, began, JobInput::kModel, [&](Session& session) {
      session.plan = outcome;
      session.plan_request = plan_request;
      session.plan_model = currentModel(began).id;
      putResult(session, "plan", currentModel(began).id, figures);
    });
    return "plan";
  });
}

/// Returns one sentence for each note on a work list: excluded tubes, and tubes included although their state is
/// doubtful.
std::vector<std::string> listWords(const tubesheets::Sheet& sheet, const tubesheets::Selection& selection) {
  std::vector<std::string> words = listNotes(selection);
  if (const std::string omitted = leftOutText(selection); !omitted.empty()) words.push_back("left out: " + omitted);
  if (const std::string doubtful = doubtfulText(sheet, selection); !doubtful.empty()) words.push_back(doubtful);
  return words;
}

struct ListText {
  std::string name, text;
};

/// Returns the name and the text of a work list, from {"name", "text"}.
ListText listTextOf(const json& list) {
  ListText given{textOf(list, "name", "list.csv").substr(0, 200), textOf(list, "text")};
  requireTable(given.name, given.text);
  checkText(given.name, given.text);
  return given;
}

/// Returns the tubes of a work list and their dwell times [s], as `plan --tubes LIST.csv` reads them, for the request
/// {"name", "text", "columns"?: ["row=Reihe"]}. `columns` gives the meaning of unrecognized headings.
Answer workList(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const auto& sheet = requireSheet(currentModel(workbench.session()).cell, "read a work list");
  const auto [name, text] = listTextOf(body);
  const auto selection = readWorkList(text, name, sheet, "tubes", textsOf(body, "columns"));
  json dwell_times = json::object();
  for (const auto& [tube, dwell] : selection.dwell) dwell_times[std::to_string(tube)] = dwell;
  return answerOf({{"name", name},
                   {"tubes", selection.tube_indices},
                   {"stays", dwell_times},
                   {"notes", listWords(sheet, selection)}});
}

/// Returns the likely meanings of the columns of a work list, for the request {"tables": [{"name", "text"}]}.
Answer listColumns(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const auto& tables = requiredOf(body, "tables", "one table of text");
  if (!tables.is_array() || tables.size() != 1)
    throw InputError("request (tables)", tables.is_array() ? fmt::format("{} tables", tables.size()) : "no list",
                     "a list of one table of text");
  const Cell cell = currentModel(workbench.session()).cell;
  (void)requireSheet(cell, "read a work list");
  const auto [name, text] = listTextOf(tables[0]);
  return answerOf(tubeColumnsJson(text, name, cell.arm));
}

Answer noPlan() { return refusal(404, InputError::problem("plan", "there is no plan yet", "plan tube visits first")); }

Answer path(Workbench& workbench, const Request&) {
  const Session now = workbench.session();
  return now.plan ? answerOf(pathAnswer(*now.plan)) : noPlan();
}

/// Returns a query parameter, a whole number of at least 0; `otherwise` if it is missing.
std::size_t countOf(const Request& request, const std::string& key, std::size_t otherwise) {
  const auto found = request.query.find(key);
  if (found == request.query.end()) return otherwise;
  const auto number = tubesheets::parseInteger(found->second);
  if (!number || *number < 0)
    throw InputError("request (" + key + ")", inQuotes(found->second), "a whole number, 0 or more");
  return static_cast<std::size_t>(*number);
}

Answer clearance(Workbench& workbench, const Request& request) {
  const Session now = workbench.session();
  if (!now.plan) return noPlan();
  return answerOf(clearanceAlong(*now.plan, countOf(request, "from", 0), countOf(request, "count", kMostClearances)));
}

constexpr Route kPlanRoutes[] = {
    {"POST", "reach", reach},     {"POST", "field", field},
    {"POST", "inverse", inverse}, {"POST", "plan", plan},
    {"GET", "plan/path", path},   {"GET", "plan/clearance", clearance},
    {"POST", "tubes", workList},  {"POST", "tubes/columns", listColumns, true},
};

}  // namespace

void requirePlanned(const PlanOutcome& outcome) {
  if (outcome.plan.status == planner::VisitPlanStatus::kStopped) throw JobStopped{};
  if (outcome.plan.status == planner::VisitPlanStatus::kPlanned) return;
  const std::string first = outcome.plan.unreachable.empty() ? "" : ": " + outcome.plan.unreachable.front().reason;
  throw InputError::problem("tubes", outcome.plan.reason + first, "choose tubes that the arm can visit");
}

std::span<const Route> planRoutes() { return kPlanRoutes; }

}  // namespace tubeplan::app
