// Writer of arms in URDF, the robot description format of ROS.
#pragma once

#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::app {

struct UrdfText {
  std::string text;
  std::vector<std::string> left_out;  ///< data of the arm that URDF cannot express, one sentence each
};

/// Returns the arm as a rigid robot in URDF [m, rad, kg]: rows become links, weights become masses at their common
/// centre, and the tip becomes the link `tip`, whose z axis is the tool axis.
[[nodiscard]] UrdfText urdfOf(const deflection::Arm& arm);

/// Returns data of an arm that no URDF can express, one sentence each.
[[nodiscard]] std::vector<std::string> beyondUrdf(const deflection::Arm& arm);

/// Returns the rotation of the tip frame relative to the last row's frame: the drawn tool frame if its z axis is the
/// tool axis, otherwise the smallest rotation that turns z to the tool axis.
[[nodiscard]] Eigen::Matrix3d urdfTipTurn(const deflection::Arm& arm);

/// Returns the text escaped for an XML attribute in double quotes.
[[nodiscard]] std::string xmlEscaped(const std::string& text);

}  // namespace tubeplan::app
