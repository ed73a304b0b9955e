// Session as JSON for browsers: small, and sent completely at every change.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json stateJson(const Workbench& workbench);

/// Returns {name, units, joints, rows: [...]}. Each row is a measurement with its line number in the file, its position
/// (null if unknown) and the tip predicted by the model in the world frame (null without equilibrium).
[[nodiscard]] nlohmann::json measurementsJson(const Model& model, const MeasurementSet& set);

}  // namespace tubeplan::app
