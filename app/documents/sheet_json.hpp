// A tube sheet as report pages take it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/files/cell_reader.hpp"

namespace tubeplan::app {

/// {name, leg, viewed_from, hole_diameter, pitch, rows, columns, holes: [[row, column, x, y, state], ...],
/// fingerprint}, in the cell's units.
[[nodiscard]] nlohmann::json sheetPageJson(const tubesheets::Sheet& sheet, const Cell& cell);

}  // namespace tubeplan::app
