// The plan of a job as a JSON document and as text: shares of the time, and the schedule of each arm.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/outage/job_plan.hpp"

namespace tubeplan::app {

/// Returns {job, legs: [{steam_generator, leg, mount_s, total_s, arm, start_s, end_s, wait, packages: [{package,
/// folder, visits, unreachable: [{tube, reason}], travel_s, approaches_s, acquisition_s, in_tubes_s, dwell_s, change_s,
/// total_s, reason}]}], arms, end_s, lower_bound_s, schedule, visits, unreachable, times: [{key, words, time_s,
/// share}]}. acquisition_s = in_tubes_s + dwell_s. `wait` is {for, reason, idle_s} or null: the leg that must end
/// first, "arm" or "apart", and the arm's preceding idle time. `times` are the parts of all work, in their
/// order.
[[nodiscard]] nlohmann::json jobPlanJson(const JobPlan& plan, const JobFile& job);
[[nodiscard]] std::string jobPlanText(const nlohmann::json& plan);

}  // namespace tubeplan::app
