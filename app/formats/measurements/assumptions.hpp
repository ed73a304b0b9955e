// Assumptions of the user about mistakes in measurements (--assume), which correct the measurements in memory.
#pragma once

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/measurements/measurements_reader.hpp"

namespace tubeplan::app {

/// Name of the assumption that the measurements are correct even if checks find mistakes.
inline constexpr const char* kAsIs = "as-is";

/// Returns the syntax of all assumptions: "coordinates=UNIT, loads=UNIT, ...".
[[nodiscard]] std::string assumptionsText();

/// Applies assumptions NAME=VALUE in the given order; the names are those of calibration::mistakeKinds(). Of
/// contradictory assumptions, such as two units of the coordinates, the last applies. Returns true if the assumption
/// `as-is` is given, which permits measurements that look wrong. Throws InputError for an unknown name or value.
bool takeAssumptions(const std::vector<std::string>& assume, MeasurementTable& table, Cell& cell);

}  // namespace tubeplan::app
