// What an effect does to the tip, for drawing.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// {effect, at, variable, unit, values, shift, shift_unit}: the tip's shift against what the effect follows most on
/// this arm, in the cell's units; without values where it does not move the tip. `most_load` [N]: of a load's sweep.
/// Throws InputError for an effect or a place that the arm does not have.
[[nodiscard]] nlohmann::json signatureJson(const Cell& cell, const std::string& effect, const std::string& at,
                                           double most_load);

}  // namespace tubeplan::app
