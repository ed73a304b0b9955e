#include "app/outage/job_plan_json.hpp"

#include <nlohmann/json.hpp>

#include "app/documents/figures_text.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

constexpr double kHour = 3600;  // [s]

/// A part of the time of a job: its key in packages and legs, and its words.
struct TimePart {
  const char* key;
  const char* words;
};
constexpr TimePart kTimeParts[] = {{"mount_s", "mounting"},       {"change_s", "tool change"},
                                   {"travel_s", "travel"},        {"approaches_s", "up and down"},
                                   {"in_tubes_s", "in the tube"}, {"dwell_s", "dwell"}};

json packageJson(const PackagePlan& plan) {
  json result = {
      {"package", plan.package}, {"folder", plan.folder},           {"reason", plan.reason},
      {"reused", plan.reused},   {"visits", plan.visits},           {"unreachable", json::array()},
      {"travel_s", plan.travel}, {"approaches_s", plan.approaches}, {"in_tubes_s", plan.in_tubes},
      {"dwell_s", plan.dwell},   {"change_s", plan.change},         {"acquisition_s", plan.in_tubes + plan.dwell},
      {"total_s", plan.total()}, {"total_h", plan.total() / kHour}};
  for (const auto& [tube, reason] : plan.unreachable)
    result["unreachable"].push_back({{"tube", addressText(tube)}, {"reason", reason}});
  return result;
}

json waitJson(const ScheduledLeg& at, const std::vector<LegPlan>& legs) {
  if (at.wait == WaitReason::kNone) return nullptr;
  const LegPlan& other = legs[static_cast<std::size_t>(at.waits_for)];
  const bool is_exclusive = at.wait == WaitReason::kExclusive;
  return {
      {"for", addressText(LegName{other.generator, other.leg})},
      {"reason", is_exclusive ? "apart" : "arm"},
      {"words", is_exclusive ? "the two legs must not have an arm at the same time" : "its arm works there until then"},
      {"idle_s", at.idle},
      {"idle_h", at.idle / kHour}};
}

json legJson(const LegPlan& leg, const ScheduledLeg& at, const std::vector<LegPlan>& legs) {
  json result = {{"steam_generator", leg.generator},
                 {"leg", tubesheets::legName(leg.leg)},
                 {"mount_s", leg.mount},
                 {"total_s", leg.total()},
                 {"arm", at.arm + 1},
                 {"start_s", at.start},
                 {"end_s", at.end},
                 {"start_h", at.start / kHour},
                 {"end_h", at.end / kHour},
                 {"wait", waitJson(at, legs)},
                 {"packages", json::array()}};
  for (const PackagePlan& package : leg.packages) result["packages"].push_back(packageJson(package));
  return result;
}

/// Returns the time of every part, over all legs.
json timesJson(const json& legs) {
  json times = json::array();
  double all = 0;
  for (const TimePart& part : kTimeParts) {
    double sum = 0;
    for (const json& leg : legs) {
      sum += leg.value(part.key, 0.);
      for (const json& package : leg["packages"]) sum += package.value(part.key, 0.);
    }
    all += sum;
    times.push_back({{"key", part.key}, {"words", part.words}, {"time_s", sum}, {"time_h", sum / kHour}});
  }
  for (json& time : times) time["share"] = all > 0 ? time["time_s"].get<double>() / all : 0.;
  return times;
}

constexpr TextLine kReusedWords[] = {{"reused", "    reused: {}\n"}};
constexpr TextLine kLegWords[] = {
    {"wait", "  waits for {for}: {words}\n"},
    {"+wait/idle_h", "  its arm is idle for {:.2f} h before\n"},
    {"packages",
     "  {package:<16} {visits:>6} (visit |visits) {#unreachable:>5} out of reach {total_h:>8.2f} h: travel "
     "{travel_s:.0f} s, up "
     "and down {approaches_s:.0f} s, in the tubes {in_tubes_s:.0f} s, dwell {dwell_s:.0f} s, tool {change_s:.0f} s\n",
     kReusedWords},
};
constexpr TextLine kWords[] = {
    {"", "{job}\n"},
    {"legs", "{steam_generator}/{leg}: arm {arm}, {start_h:.2f} to {end_h:.2f} h\n", kLegWords},
    {"notes", "note: {}\n"},
    {"times", "{words:<12} {time_h:>8.2f} h {share:>6.1%} %\n"},
    {"",
     "{visits} visit(|s), {unreachable} out of reach; {arms} (arm ends|arms end) after {end_h:.2f} h ({schedule}; no "
     "schedule ends "
     "before "
     "{lower_bound_h:.2f} h)\n"},
};

}  // namespace

json jobPlanJson(const JobPlan& plan, const JobFile& job) {
  json result = {{"job", job.name},
                 {"legs", json::array()},
                 {"notes", json::array()},
                 {"arms", job.arms},
                 {"end_s", plan.schedule.end},
                 {"end_h", plan.schedule.end / kHour},
                 {"lower_bound_s", plan.schedule.lower_bound},
                 {"lower_bound_h", plan.schedule.lower_bound / kHour},
                 {"schedule", plan.schedule.status == ScheduleStatus::kOptimal ? "optimal" : "feasible"}};
  std::size_t visits = 0, unreachable = 0;
  for (std::size_t k = 0; k < plan.legs.size(); ++k) {
    result["legs"].push_back(legJson(plan.legs[k], plan.schedule.legs[k], plan.legs));
    for (const PackagePlan& package : plan.legs[k].packages) {
      visits += static_cast<std::size_t>(package.visits);
      unreachable += package.unreachable.size();
    }
  }
  for (const WorkPackage& package : job.packages)
    if (const std::string note = untimedText(package, job); !note.empty()) result["notes"].push_back(note);
  result["times"] = timesJson(result["legs"]);
  result["visits"] = visits;
  result["unreachable"] = unreachable;
  return result;
}

std::string jobPlanText(const json& plan) { return textOf(plan, kWords); }

}  // namespace tubeplan::app
