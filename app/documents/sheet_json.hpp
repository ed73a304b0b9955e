// Tube sheet as JSON, for documents and report pages.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Returns {center, diameter} of the manway; null if the sheet states none.
[[nodiscard]] nlohmann::json manwayJson(const tubesheets::Sheet& sheet, const Units& units);

/// Returns {name, leg, leg_words, viewed_from, view_words, hole_diameter, pitch, rows, columns, holes: [[row, column,
/// x, y, state], ...], state_words, manway: direction [x, y] or null, fingerprint}, in the cell's units.
[[nodiscard]] nlohmann::json sheetPageJson(const tubesheets::Sheet& sheet, const Cell& cell);

}  // namespace tubeplan::app
