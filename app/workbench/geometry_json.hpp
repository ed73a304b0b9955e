// Sheet and scene of a cell in the form that the page draws, in the cell's units and the world frame (the sheet's
// frame).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Returns {name, units, pitch, hole_diameter, rows, columns, leg, leg_words, viewing_side, view_words, X_WS,
/// fingerprint, tool, manway, holes}. `holes` has one array for each property (row, column, x, ...), in the order of
/// the sheet's holes; u, v are drawing coordinates seen from the viewing side.
[[nodiscard]] nlohmann::json sheetDrawing(const Cell& cell, const tubesheets::Sheet& sheet);

/// Returns {units, clearance, shapes: [{name, kind, allow, the fields of the kind as in a cell file, and outline}],
/// warnings, arm: [{row, name, moves, bodies: [the same in the row's frame]}], tip: [3] in the last row's frame}. The
/// outline of a solid has the coordinates of points on its surface; it is null for a region. A mesh appears as its
/// bounding box, with mesh: {file, solid, triangles, positions if they are few}.
[[nodiscard]] nlohmann::json sceneDrawing(const Cell& cell);

}  // namespace tubeplan::app
