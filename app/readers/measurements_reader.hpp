// Measurements: comma-separated text whose columns carry their units in their names.
#pragma once

#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "deflection/arm.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::app {

/// The readings of a file, in its order. Columns: id, kind, point, setup, load_UNIT, <joint>_UNIT for every joint of
/// the arm, x_UNIT, y_UNIT, z_UNIT, distance_UNIT, sigma_UNIT, <joint>_dir, temperature_UNIT, time_UNIT, split (fit,
/// held-out); only id, kind and the joints must be there. A touch without coordinates whose point is a hole's name
/// (R10C20) takes them from the sheet, where one is given. Throws InputError naming the line and column for: an
/// unknown, double or missing column, an unknown unit, a number that is none or not finite, an unknown kind, a double
/// id, coordinates that a kind needs or that are given in part, a point that is not on the sheet, a joint reading past
/// its limits.
[[nodiscard]] std::vector<calibration::Measurement> readMeasurements(const std::string& path,
                                                                     const deflection::Arm& arm,
                                                                     const tubesheets::Sheet* sheet = nullptr);

/// The same from text; `file` is the name for messages.
[[nodiscard]] std::vector<calibration::Measurement> parseMeasurements(const std::string& text, const std::string& file,
                                                                      const deflection::Arm& arm,
                                                                      const tubesheets::Sheet* sheet = nullptr);

}  // namespace tubeplan::app
