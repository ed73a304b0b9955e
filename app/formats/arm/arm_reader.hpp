// Reader of arm files. They describe the links (Denavit-Hartenberg parameters or origins, joints, stiffnesses, beams,
// weights) and the tool.
#pragma once

#include <string>

#include "app/formats/units.hpp"
#include "app/formats/yaml/yaml_node.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

struct ArmSource {
  deflection::Arm arm;
  Units units;
  bool names_tool_axis = false;  ///< false if the tool axis is the default, which a cell may override
  std::string pair;  ///< identifier shared with the cell that was written together with this arm; empty if none
};

/// Reads an arm from the map of an arm file, or from the same map inline in a cell. Throws InputError, with the line in
/// the file, for unknown, missing or ill-typed values, and for problems found by deflection::findProblems.
[[nodiscard]] ArmSource readArm(const YamlNode& node);

/// Returns the key under which an arm file states the reference value of a condition, at which the arm has its nominal
/// shape: `reference_temperature`.
[[nodiscard]] std::string referenceKey(const deflection::ConditionKind& kind);

}  // namespace tubeplan::app
