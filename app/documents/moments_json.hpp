// Moments about the axes of the arm's rows at each measurement, used as abscissae in plots of errors. The moments have
// the names used in formulas.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/measurement.hpp"

namespace tubeplan::app {

/// Returns {unit, names: ["moment_forearm_z", ...], measurements: {ID: [one number for each name]}}: the moments that
/// the weights and the attached load cause in the undeflected arm, in the cell's units.
[[nodiscard]] nlohmann::json momentsJson(const Cell& cell, const std::vector<calibration::Measurement>& measurements);

}  // namespace tubeplan::app
