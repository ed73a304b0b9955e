#include "app/workbench/kept_plan.hpp"

#include <memory>
#include <nlohmann/json.hpp>

#include "app/documents/plan_files.hpp"
#include "app/jobs/plan.hpp"
#include "app/workbench/job_routes.hpp"

namespace tubeplan::app {

nlohmann::json planRequestJson(const PlanRequest& request) {
  nlohmann::json dwell_times = nlohmann::json::array();
  for (const auto& [tube, dwell] : request.dwell_times) dwell_times.push_back({tube, dwell});
  return {{"cell", request.cell},
          {"tubes", request.tubes},
          {"truth", request.truth},
          {"compensation", request.compensation},
          {"travel", request.travel},
          {"load", request.load},
          {"start", request.conditions.start},
          {"end", request.conditions.end},
          {"first", request.conditions.first},
          {"dwell", request.conditions.dwell},
          {"stays", dwell_times},
          {"padding", request.padding},
          {"standoff", request.standoff ? nlohmann::json(*request.standoff) : nlohmann::json()},
          {"least_standoff", request.has_least_standoff},
          {"insertion", request.insertion},
          {"seed", request.seed}};
}

PlanRequest planRequestOf(const nlohmann::json& json) {
  PlanRequest request;
  request.cell = json.at("cell");
  request.tubes = json.at("tubes");
  request.truth = json.at("truth");
  request.compensation = json.at("compensation");
  request.travel = json.at("travel");
  request.load = json.at("load");
  request.conditions = {json.at("start"), json.at("end"), json.at("first").get<std::vector<std::string>>(),
                        json.at("dwell")};
  for (const auto& dwell : json.at("stays")) request.dwell_times[dwell.at(0).get<int>()] = dwell.at(1).get<double>();
  request.padding = json.at("padding");
  if (!json.at("standoff").is_null()) request.standoff = json.at("standoff").get<double>();
  request.has_least_standoff = json.at("least_standoff");
  request.insertion = json.at("insertion");
  request.seed = json.at("seed");
  return request;
}

void restorePlan(Workbench& workbench) {
  const Session kept = workbench.session();
  if (kept.plan || kept.plan_model < 0 || !findModel(kept, kept.plan_model)) return;
  (void)beginJob(workbench, "plan", "Plan of the last session", [&workbench](JobContext& context) {
    const Session began = workbench.session();
    const auto at = findModel(began, began.plan_model);
    if (!at) throw JobStopped{};
    const PlanRequest plan_request = began.plan_request;
    const auto outcome =
        std::make_shared<const PlanOutcome>(planCell(began.models[*at]->cell, plan_request, planHooksOf(context)));
    requirePlanned(*outcome);
    const nlohmann::json figures = planJson(plan_request, *outcome);
    const auto put = [&](Session& session) {
      if (session.plan || session.plan_model != began.plan_model) return false;
      session.plan = outcome;
      putResult(session, "plan", session.plan_model, figures);
      return true;
    };
    workbench.change(put, false);
    return "plan";
  });
}

}  // namespace tubeplan::app
