// Computations for every hole of a sheet, in parallel.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/workbench/jobs.hpp"
#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// Returns {reachable: [0 or 1], reason: [text], branches: [count]}, by hole. Throws JobStopped.
[[nodiscard]] nlohmann::json reachOfAll(const Cell& cell, JobContext& context);

/// Returns {of, meaning, unit, values: [number or null], steps: [0.. or -1]} by hole. `sag`: distance of the tip below
/// that of a rigid arm. `centring`: distance of the tip from the hole's centre, by the true arm if one is named, else
/// by this model at joint angles of rigid kinematics. `residual`: remaining error at the holes that the readings
/// touched. Throws InputError for another word, JobStopped.
[[nodiscard]] nlohmann::json fieldOf(const Session& session, const std::string& of, JobContext& context);

void requireField(const std::string& of);

}  // namespace tubeplan::app
