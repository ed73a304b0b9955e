// Conversion of a cell to the planner's model.
#pragma once

#include "app/formats/cell/cell_reader.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Returns the planner's model of a cell. Throws InputError if the cell has no tube sheet or calibration tool, or if
/// the planner does not support the arm; `purpose` completes "needed to ..." in the message.
[[nodiscard]] planner::Workcell workcellOf(const Cell& cell, const std::string& purpose);

/// Throws InputError for an arm with a joint that has neither a speed nor an acceleration limit, because its motions
/// would be instantaneous.
void requireSpeeds(const Cell& cell);

}  // namespace tubeplan::app
