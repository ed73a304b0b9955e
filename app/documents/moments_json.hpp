// Moments about the arm's rows at each reading, as abscissae for plots of errors, with the names that formulas use.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/measurement.hpp"

namespace tubeplan::app {

/// Returns {unit, names: ["moment_forearm_z", ...], readings: {ID: [one number for each name]}}: moments of the
/// undeflected arm under its weights and the attached load, in the cell's units, named like the symbols of a formula.
[[nodiscard]] nlohmann::json momentsJson(const Cell& cell, const std::vector<calibration::Measurement>& readings);

}  // namespace tubeplan::app
