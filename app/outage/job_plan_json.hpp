// The plan of a job as a JSON document and as text: where the time goes, and which arm works where and when.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/outage/job_plan.hpp"

namespace tubeplan::app {

/// Returns {job, legs: [{steam_generator, leg, mount_s, total_s, arm, start_s, end_s, wait, packages: [{package,
/// folder, visits, unreachable: [{tube, reason}], travel_s, approaches_s, acquisition_s, in_tubes_s, dwell_s, change_s,
/// total_s, reason}]}], arms, end_s, lower_bound_s, schedule, visits, unreachable, times: [{key, words, time_s,
/// share}]}. acquisition_s = in_tubes_s + dwell_s. `wait` is {for, reason, idle_s} or null: the leg that must end
/// first, "arm" or "apart", and the time that the arm is in no leg before. `times` are the parts of all work, in its
/// order.
[[nodiscard]] nlohmann::json jobPlanJson(const JobPlan& plan, const JobFile& job);
[[nodiscard]] std::string jobPlanText(const nlohmann::json& plan);

}  // namespace tubeplan::app
