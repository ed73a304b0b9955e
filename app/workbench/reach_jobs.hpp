// Questions asked of every hole of a sheet, in parallel.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/workbench/jobs.hpp"
#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// {reachable: [0 or 1], reason: [text], branches: [count]}, by hole. Throws JobStopped.
[[nodiscard]] nlohmann::json reachOfAll(const Cell& cell, JobContext& context);

/// {of, meaning, unit, values: [number or null], steps: [0.. or -1]} by hole: `sag`, how far the tip hangs from where a
/// rigid arm would have it; `centring`, how far it comes from the centre, of the true arm where one is named, else of
/// this one when it is sent there by rigid kinematics; `residual`, what the model leaves at the holes that the readings
/// touched. Throws InputError for another word, JobStopped.
[[nodiscard]] nlohmann::json fieldOf(const Session& session, const std::string& of, JobContext& context);

void requireField(const std::string& of);

}  // namespace tubeplan::app
