// Units in JSON documents, so that programs can compare the units of two documents.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/units.hpp"

namespace tubeplan::app {

/// Returns the names of the units as an object: {"length": "in", "angle": "deg", ...}.
[[nodiscard]] nlohmann::json unitsJson(const Units& units);

/// Returns unitsJson() with an entry `conditions: [{name, unit}]` for the conditions that measurements may state.
[[nodiscard]] nlohmann::json measurementUnitsJson(const Units& units);

/// Returns the units of length and angle that can be chosen, with their sizes in m and rad, in the order of the table:
/// {"length": [{"name": "in", "factor": 0.0254}, ...], "angle": [...]}.
[[nodiscard]] nlohmann::json unitTableJson();

}  // namespace tubeplan::app
