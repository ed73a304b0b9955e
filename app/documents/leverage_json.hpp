// Leverage of each joint at each reading: the displacement of the tip by a small rotation of the joint, which converts
// an error at the tip into an error of one joint.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/measurement.hpp"

namespace tubeplan::app {

/// Returns {units, names, base, up, tool: {ID: [9 numbers]}, readings: {ID: [three numbers for each name]}}. A name is
/// a joint ("theta3") or an axis of a row ("forearm.z"); its numbers are the tip's motion in the world per unit of the
/// joint, or per unit of angle about the axis, in the cell's units; `units`: those of joint or axis. `tool`: the
/// deflected tool's axes in the world, one after another; `base`: the base's place in the first set-up; `up`: direction
/// against gravity. A base that the cell does not place is taken from the readings. Throws InputError for another name.
[[nodiscard]] nlohmann::json leverageJson(const Cell& cell, const std::vector<calibration::Measurement>& readings,
                                          const std::vector<std::string>& names);

/// Returns true if a name at which a found effect may act is a rotation of a row about one of its axes, which
/// leverageJson() accepts: "forearm.z", but not "theta3" or "theta3<-theta2".
[[nodiscard]] bool isAxisOfRow(const deflection::Arm& arm, const std::string& at);

}  // namespace tubeplan::app
