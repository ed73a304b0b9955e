// Remarks on suspicious values in a URDF file.
#pragma once

#include <string>
#include <vector>

#include "app/formats/urdf/urdf_tree.hpp"

namespace tubeplan::app {

/// Returns remarks on the joints of a chain, given as the links from the root outwards. They concern rounded angles
/// that make the tip inexact, angles and limits that may be in degrees, and positions that may be in millimetres.
[[nodiscard]] std::vector<std::string> remarksOnNumbers(const std::vector<const UrdfTree::Link*>& chain);

}  // namespace tubeplan::app
