// Leverage of each joint at each measurement: the displacement of the tip per unit of joint motion. It converts a tip
// error into a joint error.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/measurement.hpp"

namespace tubeplan::app {

/// Returns {units, names, base, up, tool: {ID: [9 numbers]}, measurements: {ID: [three numbers for each name]}}. Each
/// of `names` is a joint ("theta3") or an axis of a row ("forearm.z"). Its three numbers are the motion of the tip in
/// the world frame per unit of the joint, or per unit of angle about the axis; `units` names these units. `tool` has
/// the axes of the deflected tool in the world frame, one after another. `base` is the base position in the first
/// set-up, and `up` the direction against gravity. Base poses that the cell does not state are fitted to the
/// measurements. Throws InputError for an unknown name.
[[nodiscard]] nlohmann::json leverageJson(const Cell& cell, const std::vector<calibration::Measurement>& measurements,
                                          const std::vector<std::string>& names);

/// Returns true if `at`, the place of an effect, is an axis of a row that leverageJson() accepts, such as "forearm.z",
/// but not "theta3" or "theta3<-theta2".
[[nodiscard]] bool isAxisOfRow(const deflection::Arm& arm, const std::string& at);

}  // namespace tubeplan::app
