// The cell of a steam generator's other leg, which is the mirror image of the first one in the divider plate (y -> -y).
#pragma once

#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Returns the text of the other leg's cell: sheet, manway, obstacles, gravity and nominal base pose are mirrored in
/// the plane y = 0, and the arm is unchanged. Rows and columns keep their numbers. The text has no covariance of the
/// base, no touches and no park posture, because those belong to the first leg. Throws InputError for a sheet without
/// legs, a hole map and a mesh, because this function cannot mirror them.
[[nodiscard]] std::string mirroredCellText(const Cell& cell);

/// Returns the other leg's cell; messages name it by the path of the given cell.
[[nodiscard]] Cell mirroredCell(const Cell& cell);

}  // namespace tubeplan::app
