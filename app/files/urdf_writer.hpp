// Arms as URDF, the format that ROS describes robots in.
#pragma once

#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::app {

struct UrdfText {
  std::string text;
  std::vector<std::string> left_out;  ///< what URDF has no place for, a sentence each
};

/// The arm as it stands rigid: rows as links, weights as masses at their common centre, the tip as the link `tip` with
/// the tool's axis along its z. m, rad and kg.
[[nodiscard]] UrdfText urdfOf(const deflection::Arm& arm);

}  // namespace tubeplan::app
