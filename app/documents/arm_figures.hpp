// Summary of an arm, as text and JSON, with which users can check an arm file: rows, joints, compliances and weights.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// Returns {name, reach, weight, joints, rows: [{name, joint, type, position, origin, z_axis, limits, compliant,
/// weight}], tip, units}. Positions and axes are in the base frame, with all joints at zero.
[[nodiscard]] nlohmann::json armJson(const deflection::Arm& arm, const Units& units);

[[nodiscard]] std::string armText(const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
