// How far a small turn of a joint takes the tip, at each reading: what makes an error at the tip an error of one joint.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// {units, names, base, up, tool: {ID: [9 numbers]}, readings: {ID: [three numbers for each name]}}. A name is a joint
/// ("theta3") or an axis of a row ("forearm.z"); its numbers are the tip's motion in the world per unit of the joint,
/// or per unit of angle about the axis, in the cell's units; `units`: those of joint or axis. `tool`: the deflected
/// tool's axes in the world, one after another; `base`: where the base stands; `up`: against gravity. Throws InputError
/// for another name.
[[nodiscard]] nlohmann::json leverageJson(const Cell& cell, const ReadingSet& set,
                                          const std::vector<std::string>& names);

}  // namespace tubeplan::app
