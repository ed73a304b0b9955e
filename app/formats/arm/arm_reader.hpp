// Arm files: rows of links by Denavit-Hartenberg numbers or origins, with joints, stiffnesses, beams, weights and the
// tool.
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
  bool names_tool_axis = false;  ///< true: the axis is stated; false: it is the default, which a cell may replace
  std::string pair;              ///< identifier of the pair with the cell written together with it; empty if none
};

/// Reads the map of an arm file, or the same map inline in a cell. Throws InputError, with the file's line, for
/// unknown, missing or ill-typed values and for the problems of deflection::findProblems.
[[nodiscard]] ArmSource readArm(const YamlNode& node);

/// Returns the key of a condition's value at which the arm has its drawn shape: `reference_temperature`.
[[nodiscard]] std::string referenceKey(const deflection::ConditionKind& kind);

/// Returns the node of a parameter by its dotted name ("tool.joint_stiffness.z", "tool.tip.x"), or the nearest node
/// around it.
[[nodiscard]] const YamlNode& findArmNode(const YamlNode& arm, std::string_view name);

/// Returns a parameter's path in the file for withYamlValue ("links[5].joint_stiffness.z", "tool.tip[0]"), also for a
/// value that the file lacks. Empty for a name that no row of the arm has.
[[nodiscard]] std::string armPath(const YamlNode& arm, std::string_view name);

/// Returns the arm's text with new values of these parameters (dotted name, internal value) and everything else
/// unchanged. `arm` is the map within the text: the whole file, or a cell's `arm`.
[[nodiscard]] std::string withArmParameters(const std::string& text, const YamlNode& arm, const ArmSource& source,
                                            const std::vector<std::pair<std::string, double>>& parameters);

/// Returns the text without these stiffnesses (dotted names), so that their axes are rigid.
[[nodiscard]] std::string withoutArmParameters(const std::string& text, const YamlNode& arm,
                                               const std::vector<std::string>& names);

}  // namespace tubeplan::app
