// Writer of complete arms in Tubeplan's own file format.
#pragma once

#include <string>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Choice of whether armYaml() writes the tool axis. It is omitted if the arm's original file has none, so that the
/// cell can define it.
enum class ToolAxis { kStated, kLeftOut };

/// Returns the text of an arm file that readArm() can read. Effects are not written, because they belong to the cell.
[[nodiscard]] std::string armYaml(const deflection::Arm& arm, const Units& units,
                                  ToolAxis tool_axis = ToolAxis::kStated);

}  // namespace tubeplan::app
