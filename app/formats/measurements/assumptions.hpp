// Assumptions of the user about errors in readings (--assume), and readings corrected accordingly in memory.
#pragma once

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/measurements/measurements_reader.hpp"

namespace tubeplan::app {

/// Name of the assumption that nothing is wrong, despite the checks.
inline constexpr const char* kAsIs = "as-is";

/// Returns the syntax of all assumptions: "coordinates=UNIT, loads=UNIT, ...".
[[nodiscard]] std::string assumptionsText();

/// Applies each NAME=VALUE in turn, as in calibration::mistakeKinds(). Of contradictory ones, such as two units of the
/// coordinates, the last one applies. Returns true if `as-is` is among them, which allows readings that look wrong.
/// Throws InputError for an unknown name or value.
bool takeAssumptions(const std::vector<std::string>& assume, MeasurementTable& table, Cell& cell);

}  // namespace tubeplan::app
