// From a cell as read to what the planner works on.
#pragma once

#include "app/formats/cell/cell_reader.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Throws InputError where the cell has no tube sheet or no calibration tool, or an arm that is not planned for;
/// `purpose` continues "needed to ...".
[[nodiscard]] planner::Workcell workcellOf(const Cell& cell, const std::string& purpose);

/// Refuses an arm with a joint that nothing slows: its moves would take no time.
void requireSpeeds(const Cell& cell);

}  // namespace tubeplan::app
