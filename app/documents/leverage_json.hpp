// How far a small turn of a joint takes the tip, at each reading: what makes an error at the tip an error of one joint.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/measurement.hpp"

namespace tubeplan::app {

/// {units, names, base, up, tool: {ID: [9 numbers]}, readings: {ID: [three numbers for each name]}}. A name is a joint
/// ("theta3") or an axis of a row ("forearm.z"); its numbers are the tip's motion in the world per unit of the joint,
/// or per unit of angle about the axis, in the cell's units; `units`: those of joint or axis. `tool`: the deflected
/// tool's axes in the world, one after another; `base`: where the base stands, of the first set-up; `up`: against
/// gravity. A base that the cell does not place stands where the readings have it. Throws InputError for another name.
[[nodiscard]] nlohmann::json leverageJson(const Cell& cell, const std::vector<calibration::Measurement>& readings,
                                          const std::vector<std::string>& names);

/// Of the names a found effect may stand at ("theta3", "theta3<-theta2", "forearm.z"), whether it turns a row about one
/// of its axes, which leverageJson() then takes: "forearm.z".
[[nodiscard]] bool isAxisOfRow(const deflection::Arm& arm, const std::string& at);

}  // namespace tubeplan::app
