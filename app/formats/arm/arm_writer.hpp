// Writer of complete arms in Tubeplan's own file format.
#pragma once

#include <string>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Choice of whether armYaml() writes the tool axis. It is left out if the arm's own file states none, so that the cell can state
/// it.
enum class ToolAxis { kStated, kLeftOut };

/// Returns the text of an arm file that readArm() can read. It has no effects, because they belong to the cell.
[[nodiscard]] std::string armYaml(const deflection::Arm& arm, const Units& units,
                                  ToolAxis tool_axis = ToolAxis::kStated);

}  // namespace tubeplan::app
