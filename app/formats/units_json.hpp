// Units in JSON documents, for readers to compare.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/units.hpp"

namespace tubeplan::app {

/// Returns the units as {"length": "in", "angle": "deg", ...}.
[[nodiscard]] nlohmann::json unitsJson(const Units& units);

/// Returns the units, with the conditions that readings may state as `conditions: [{name, unit}]`.
[[nodiscard]] nlohmann::json readingUnitsJson(const Units& units);

}  // namespace tubeplan::app
