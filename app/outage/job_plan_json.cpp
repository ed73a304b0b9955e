#include "app/outage/job_plan_json.hpp"

#include <nlohmann/json.hpp>

#include "app/documents/figures_text.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

constexpr double kHour = 3600;  // [s]

json packageJson(const PackagePlan& plan) {
  json result = {{"package", plan.package},         {"folder", plan.folder},
                 {"reason", plan.reason},           {"visits", plan.visits},
                 {"unreachable", json::array()},    {"travel_s", plan.travel},
                 {"approaches_s", plan.approaches}, {"acquisition_s", plan.acquisition},
                 {"change_s", plan.change},         {"total_s", plan.total()},
                 {"total_h", plan.total() / kHour}};
  for (const auto& [tube, reason] : plan.unreachable)
    result["unreachable"].push_back({{"tube", addressText(tube)}, {"reason", reason}});
  return result;
}

json legJson(const LegPlan& leg, const ScheduledLeg& at) {
  json result = {{"steam_generator", leg.generator},
                 {"leg", tubesheets::legName(leg.leg)},
                 {"mount_s", leg.mount},
                 {"total_s", leg.total()},
                 {"arm", at.arm + 1},
                 {"start_s", at.start},
                 {"end_s", at.end},
                 {"start_h", at.start / kHour},
                 {"end_h", at.end / kHour},
                 {"packages", json::array()}};
  for (const PackagePlan& package : leg.packages) result["packages"].push_back(packageJson(package));
  return result;
}

constexpr TextLine kPackageWords[] = {
    {"packages",
     "  {package:<16} {visits:>6} visits {#unreachable:>5} out of reach {total_h:>8.2f} h: travel {travel_s:.0f} s, up "
     "and "
     "down {approaches_s:.0f} s, in the tubes {acquisition_s:.0f} s, tool {change_s:.0f} s\n"},
};
constexpr TextLine kWords[] = {
    {"", "{job}\n"},
    {"legs", "{steam_generator}/{leg}: arm {arm}, {start_h:.2f} to {end_h:.2f} h\n", kPackageWords},
    {"",
     "{visits} visits, {unreachable} out of reach; {arms} arms end after {end_h:.2f} h ({schedule}; no schedule ends "
     "before "
     "{lower_bound_h:.2f} h)\n"},
};

}  // namespace

json jobPlanJson(const JobPlan& plan, const JobFile& job) {
  json result = {{"job", job.name},
                 {"legs", json::array()},
                 {"arms", job.arms},
                 {"end_s", plan.schedule.end},
                 {"end_h", plan.schedule.end / kHour},
                 {"lower_bound_s", plan.schedule.lower_bound},
                 {"lower_bound_h", plan.schedule.lower_bound / kHour},
                 {"schedule", plan.schedule.status == ScheduleStatus::kOptimal ? "optimal" : "feasible"}};
  std::size_t visits = 0, unreachable = 0;
  for (std::size_t k = 0; k < plan.legs.size(); ++k) {
    result["legs"].push_back(legJson(plan.legs[k], plan.schedule.legs[k]));
    for (const PackagePlan& package : plan.legs[k].packages) {
      visits += static_cast<std::size_t>(package.visits);
      unreachable += package.unreachable.size();
    }
  }
  result["visits"] = visits;
  result["unreachable"] = unreachable;
  return result;
}

std::string jobPlanText(const json& plan) { return textOf(plan, kWords); }

}  // namespace tubeplan::app
