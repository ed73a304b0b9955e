// Whole arms as files: of the program's own format, and as URDF.
#pragma once

#include <string>
#include <vector>

#include "app/files/units.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

/// The arm's file (readArm), without effects, which stand in the cell.
[[nodiscard]] std::string armYaml(const deflection::Arm& arm, const Units& units);

struct UrdfText {
  std::string text;
  std::vector<std::string> left_out;  ///< what URDF has no place for, a sentence each
};

/// The arm as it stands rigid: rows as links, weights as masses at their common centre, the tip as the link `tip` with
/// the tool's axis along its z. m, rad and kg.
[[nodiscard]] UrdfText urdfOf(const deflection::Arm& arm);

}  // namespace tubeplan::app
