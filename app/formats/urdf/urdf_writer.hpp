// Writer of arms in URDF, the robot description format of ROS.
#pragma once

#include <string>
#include <vector>

#include "deflection/arm.hpp"

namespace tubeplan::app {

struct UrdfText {
  std::string text;
  std::vector<std::string> left_out;  ///< data that URDF cannot express, a sentence each
};

/// Returns the rigid arm [m, rad, kg]: rows as links, weights as masses at their common centre, and the tip as the link
/// `tip` with its z along the tool's axis.
[[nodiscard]] UrdfText urdfOf(const deflection::Arm& arm);

/// Returns data of an arm that no URDF can express, a sentence each.
[[nodiscard]] std::vector<std::string> beyondUrdf(const deflection::Arm& arm);

/// Returns the rotation of the tip's frame relative to the last row's: the tool frame if its z is the tool's axis, else
/// the smallest rotation that makes it so.
[[nodiscard]] Eigen::Matrix3d urdfTipTurn(const deflection::Arm& arm);

/// Returns a text for use within an attribute in double quotes.
[[nodiscard]] std::string xmlEscaped(const std::string& text);

}  // namespace tubeplan::app
