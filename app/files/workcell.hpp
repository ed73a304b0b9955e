// From a cell as read to what the planner works on.
#pragma once

#include "app/files/cell_reader.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Throws InputError where the cell has no tube sheet or no calibration tool, or an arm that is not planned for;
/// `purpose` continues "needed to ...".
[[nodiscard]] planner::Workcell workcellOf(const Cell& cell, const std::string& purpose);

}  // namespace tubeplan::app
