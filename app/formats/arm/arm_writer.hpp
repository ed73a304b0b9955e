// Writer of complete arms in the program's own format.
#pragma once

#include <string>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Choice to write the tool axis, or to leave it out if the arm's own file states none, so that the cell may state it.
enum class ToolAxis { kStated, kLeftOut };

/// Returns the text of an arm's file (readArm), without effects, which belong to the cell.
[[nodiscard]] std::string armYaml(const deflection::Arm& arm, const Units& units,
                                  ToolAxis tool_axis = ToolAxis::kStated);

}  // namespace tubeplan::app
