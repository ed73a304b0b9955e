// A cell's sheet and scene as a page draws them, in the cell's units, in the world (the sheet's frame).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// {name, units, pitch, hole_diameter, rows, columns, leg, viewing_side, X_WS, fingerprint, tool, holes}: holes by
/// column of the table, in the order of the sheet. u, v: the place in a picture drawn from the viewing side.
[[nodiscard]] nlohmann::json sheetDrawing(const Cell& cell, const tubesheets::Sheet& sheet);

/// {units, clearance, shapes: [{name, kind, allow, and the fields of its kind as a cell file has them}], warnings, arm:
/// [{row, name, moves, bodies: [{name, kind, fields, in the row's frame}]}], tip: [3] in the last row's frame}. A mesh
/// is the box around it, with mesh: {file, solid, triangles, positions where they are few}.
[[nodiscard]] nlohmann::json sceneDrawing(const Cell& cell);

}  // namespace tubeplan::app
