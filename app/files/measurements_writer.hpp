// Measurements as the comma-separated text that readMeasurements reads.
#pragma once

#include <string>
#include <vector>

#include "app/files/units.hpp"
#include "calibration/measurement.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// The readings in their order, numbers in these units to 12 digits. Columns: id, kind, point, setup, load, a reading
/// for every joint, x, y, z, the kinds' own, tool_x to tool_z, dx, dy, dz, sigma, sigma_x to sigma_z, rho_xy to rho_yz,
/// turn_sigma, from, row, the joints' senses, temperature, time, split; what no reading has is left out, but for id,
/// kind, point, load, joints, x, y, z, sigma.
[[nodiscard]] std::string measurementsCsv(const std::vector<calibration::Measurement>& readings,
                                          const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
