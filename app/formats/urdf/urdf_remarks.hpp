// What looks wrong with the numbers of a URDF file and cannot be known to be.
#pragma once

#include <string>
#include <vector>

#include "app/formats/urdf/urdf_tree.hpp"

namespace tubeplan::app {

/// Remarks on the joints of a chain, links from the root on: round angles with so few digits that the tip is elsewhere,
/// angles and limits so large that they may be degrees, places so far that they may be millimetres. Nothing is changed.
[[nodiscard]] std::vector<std::string> remarksOnNumbers(const std::vector<const UrdfTree::Link*>& chain);

}  // namespace tubeplan::app
