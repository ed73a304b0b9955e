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

/// What of an arm URDF has no place for whichever way it is written, a sentence each.
[[nodiscard]] std::vector<std::string> beyondUrdf(const deflection::Arm& arm);

/// The turn of the tip's frame in the last row's: the tool frame, if its z is the tool's axis; else turned the shortest
/// way so that it is.
[[nodiscard]] Eigen::Matrix3d urdfTipTurn(const deflection::Arm& arm);

/// Text within an attribute in double quotes.
[[nodiscard]] std::string xmlEscaped(const std::string& text);

}  // namespace tubeplan::app
