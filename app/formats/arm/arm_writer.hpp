// Whole arms as files of the program's own format.
#pragma once

#include <string>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Left out where the arm's own file states none, and the cell may know better.
enum class ToolAxis { kStated, kLeftOut };

/// The arm's file (readArm), without effects, which stand in the cell.
[[nodiscard]] std::string armYaml(const deflection::Arm& arm, const Units& units,
                                  ToolAxis tool_axis = ToolAxis::kStated);

}  // namespace tubeplan::app
