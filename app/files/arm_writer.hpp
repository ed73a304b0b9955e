// Whole arms as files of the program's own format.
#pragma once

#include <string>

#include "app/files/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// The arm's file (readArm), without effects, which stand in the cell.
[[nodiscard]] std::string armYaml(const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
