// What looks wrong with the numbers of a URDF file and cannot be known to be.
#pragma once

#include <urdf_model/types.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace tubeplan::app {

/// Roll, pitch and yaw of a joint's origin as the file writes them, by the joint's name.
using WrittenTurns = std::map<std::string, std::array<double, 3>>;

/// Remarks on the joints of a chain, links from the root on: round angles with so few digits that the tip is elsewhere,
/// angles and limits so large that they may be degrees, places so far that they may be millimetres. Nothing is changed.
[[nodiscard]] std::vector<std::string> remarksOnNumbers(const std::vector<urdf::LinkConstSharedPtr>& chain,
                                                        const WrittenTurns& turns);

}  // namespace tubeplan::app
