// Arm files: rows of links by Denavit-Hartenberg numbers or origins, joints, stiffnesses, beams, weights and the tool.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/formats/units.hpp"
#include "app/formats/yaml/yaml_node.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::app {

struct ArmSource {
  deflection::Arm arm;
  Units units;
  bool names_tool_axis = false;  ///< else the axis is the default and a cell may know better
  std::string pair;              ///< of the cell that was written together with it; empty where none was
};

/// Reads the map of an arm file, or the same map inline in a cell. Throws InputError for what is not known, missing,
/// ill-typed or what deflection::findProblems finds, with the file's line.
[[nodiscard]] ArmSource readArm(const YamlNode& node);

/// The key of a condition's usual value under which the arm is as drawn: `reference_temperature`.
[[nodiscard]] std::string referenceKey(const deflection::ConditionKind& kind);

/// The value that a parameter's dotted name ("tool.joint_stiffness.z", "tool.tip.x") stands for, or the nearest one
/// around it.
[[nodiscard]] const YamlNode& findArmNode(const YamlNode& arm, std::string_view name);

/// Where a parameter stands in the file, as withYamlValue wants it ("links[5].joint_stiffness.z", "tool.tip[0]"),
/// whether it is there already or not. Empty for a name that no row of the arm has.
[[nodiscard]] std::string armPath(const YamlNode& arm, std::string_view name);

/// The arm's text with these parameters (dotted name, internal value) changed and all else as it was. `arm` is the map
/// within the text: the whole file, or a cell's `arm`.
[[nodiscard]] std::string withArmParameters(const std::string& text, const YamlNode& arm, const ArmSource& source,
                                            const std::vector<std::pair<std::string, double>>& parameters);

/// The text without these stiffnesses, dotted names as above: their axes are rigid then.
[[nodiscard]] std::string withoutArmParameters(const std::string& text, const YamlNode& arm,
                                               const std::vector<std::string>& names);

}  // namespace tubeplan::app
