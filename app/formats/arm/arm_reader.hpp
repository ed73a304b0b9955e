// Reader of arm files. They describe the links (Denavit-Hartenberg parameters or origins, joints, stiffnesses, beams,
// weights) and the tool.
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
  bool names_tool_axis = false;  ///< false: the tool axis is the default one, which a cell may replace
  std::string pair;  ///< identifier shared with the cell that was written together with this arm; empty if none
};

/// Reads an arm from the map of an arm file, or from the same map inline in a cell. Throws InputError, with the line in
/// the file, for unknown, missing or ill-typed values, and for problems found by deflection::findProblems.
[[nodiscard]] ArmSource readArm(const YamlNode& node);

/// Returns the key under which an arm file states the reference value of a condition, at which the arm has its drawn
/// shape: `reference_temperature`.
[[nodiscard]] std::string referenceKey(const deflection::ConditionKind& kind);

/// Returns the YAML node of the parameter with a dotted name ("tool.joint_stiffness.z", "tool.tip.x"), or the nearest
/// enclosing node if the file does not state the parameter.
[[nodiscard]] const YamlNode& findArmNode(const YamlNode& arm, std::string_view name);

/// Returns the path of a parameter in the arm file, for withYamlValue ("links[5].joint_stiffness.z", "tool.tip[0]"),
/// even if the file does not state the parameter. Empty if no row of the arm has the name.
[[nodiscard]] std::string armPath(const YamlNode& arm, std::string_view name);

/// Returns the arm's text with new values of the given parameters (dotted name, value in internal units) and everything
/// else unchanged. `arm` is the arm's map within `text`: the whole file, or the value of `arm` in a cell.
[[nodiscard]] std::string withArmParameters(const std::string& text, const YamlNode& arm, const ArmSource& source,
                                            const std::vector<std::pair<std::string, double>>& parameters);

/// Returns the arm's text without the stiffnesses in `names` (dotted names), whose axes thereby become rigid.
[[nodiscard]] std::string withoutArmParameters(const std::string& text, const YamlNode& arm,
                                               const std::vector<std::string>& names);

}  // namespace tubeplan::app
