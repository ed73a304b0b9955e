// Displacement of the tip that an effect causes, as JSON for plotting.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Returns {effect, at, variable, unit, values, shift, shift_unit}: the tip's displacement as a function of the
/// variable with the largest influence on this arm, in the cell's units. `values` is empty if the effect does not move
/// the tip. `most_load` [N] is the largest load of a load sweep. Throws InputError for an effect or place that the arm
/// does not have.
[[nodiscard]] nlohmann::json signatureJson(const Cell& cell, const std::string& effect, const std::string& at,
                                           double most_load);

}  // namespace tubeplan::app
