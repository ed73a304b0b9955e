// Parallel computations for every hole of a sheet.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/workbench/jobs.hpp"
#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// Returns {reachable: [0 or 1], reason: [text], branches: [count]}, with one entry for each hole. Throws JobStopped if
/// the job is cancelled.
[[nodiscard]] nlohmann::json reachOfAll(const Cell& cell, JobContext& context);

/// Returns {of, meaning, unit, units, values: [number or null], steps?: [number, -1 if unknown]}, with one entry for
/// each hole; `steps` only for `centring`. `of` selects the field: `sag` is the distance between the tips of the
/// deflected and the rigid arm; `centring` is the lateral distance of the tip from the hole's centre (for the true arm
/// if one is named, otherwise for this model at joint angles from rigid kinematics); `residual` is the distance of the
/// predicted tip from a touched hole. Throws InputError for an unknown field, and JobStopped if the job is cancelled.
[[nodiscard]] nlohmann::json fieldOf(const Session& session, const std::string& of, JobContext& context);

void requireField(const std::string& of);

}  // namespace tubeplan::app
