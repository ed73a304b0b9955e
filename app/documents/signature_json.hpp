// Displacement of the tip by an effect, for drawing.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Returns {effect, at, variable, unit, values, shift, shift_unit}: the tip's shift against the variable with the most
/// influence on this arm, in the cell's units; without values if the effect does not move the tip. `most_load` [N]
/// bounds a sweep of the load. Throws InputError for an effect or a place that the arm does not have.
[[nodiscard]] nlohmann::json signatureJson(const Cell& cell, const std::string& effect, const std::string& at,
                                           double most_load);

}  // namespace tubeplan::app
