// The moments about the arm's rows at each reading: what an error may be plotted against, named as formulas name it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/measurement.hpp"

namespace tubeplan::app {

/// {unit, names: ["moment_forearm_z", ...], readings: {ID: [one number for each name]}}: of the arm undeflected under
/// its weights and the hung load, in the cell's units, as the symbols of a formula.
[[nodiscard]] nlohmann::json momentsJson(const Cell& cell, const std::vector<calibration::Measurement>& readings);

}  // namespace tubeplan::app
