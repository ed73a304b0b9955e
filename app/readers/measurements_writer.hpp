// Measurements as the comma-separated text that readMeasurements reads.
#pragma once

#include <string>
#include <vector>

#include "app/readers/units.hpp"
#include "calibration/measurement.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// The readings in their order, numbers in these units to 12 digits. Columns: id, kind, point, setup, load, a reading
/// for every joint, x, y, z, distance, sigma, the joints' senses, temperature, time, split; setup, distance, senses,
/// temperature, time and split only where a reading has them.
[[nodiscard]] std::string measurementsCsv(const std::vector<calibration::Measurement>& readings,
                                          const deflection::Arm& arm, const Units& units);

/// As the column `kind` says it: position, touch, deflection, distance.
[[nodiscard]] const char* measurementKindName(calibration::MeasurementKind kind);

}  // namespace tubeplan::app
