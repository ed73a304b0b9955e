// Session in the form for browsers: small, and sent completely at every change.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json stateJson(const Workbench& workbench);

/// Returns {units, sigma_unit, rows: [...]}: each reading with the line of its file, its place if it has one and the
/// tip that the model predicts, in the world.
[[nodiscard]] nlohmann::json readingsJson(const Model& model, const ReadingSet& set);

}  // namespace tubeplan::app
