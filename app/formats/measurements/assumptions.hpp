// What a user says is wrong with readings (--assume), and the readings mended accordingly, in memory.
#pragma once

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/measurements/measurements_reader.hpp"

namespace tubeplan::app {

/// The assumption that nothing is wrong, whatever it looks like.
inline constexpr const char* kAsIs = "as-is";

/// "coordinates=UNIT, loads=UNIT, ...".
[[nodiscard]] std::string assumptionsText();

/// Takes each NAME=VALUE in turn, as calibration::mistakeKinds() has them; of two that cannot both hold, as two units
/// of the coordinates, the last. True where `as-is` is among them: what looks wrong is to be gone on with. Throws
/// InputError for a name or value that there is not.
bool takeAssumptions(const std::vector<std::string>& assume, MeasurementTable& table, Cell& cell);

}  // namespace tubeplan::app
