// The plan of a job as a JSON document and as text: where the time goes, and which arm works where and when.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/outage/job_plan.hpp"

namespace tubeplan::app {

/// Returns {job, legs: [{steam_generator, leg, mount_s, total_s, arm, start_s, end_s, packages: [{package, folder,
/// visits, unreachable: [{tube, reason}], travel_s, approaches_s, acquisition_s, change_s, total_s, reason}]}], arms,
/// end_s, lower_bound_s, schedule, visits, unreachable}.
[[nodiscard]] nlohmann::json jobPlanJson(const JobPlan& plan, const JobFile& job);
[[nodiscard]] std::string jobPlanText(const nlohmann::json& plan);

}  // namespace tubeplan::app
