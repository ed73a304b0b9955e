// Conversion of a cell to the planner's model.
#pragma once

#include "app/formats/cell/cell_reader.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Returns the planner's model of a cell. Throws InputError if the cell has no tube sheet or no calibration tool, or an
/// arm that the planner does not support; `purpose` continues "needed to ...".
[[nodiscard]] planner::Workcell workcellOf(const Cell& cell, const std::string& purpose);

/// Throws InputError for an arm with a joint without limits of speed and acceleration, whose moves would take no time.
void requireSpeeds(const Cell& cell);

}  // namespace tubeplan::app
