// Numbers of an arm in the text of its file: finds them by their dotted names, replaces and removes them.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/yaml/yaml_node.hpp"

namespace tubeplan::app {

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

/// Returns the arm's text without the stiffnesses in `names` (dotted names), whose axes then are rigid.
[[nodiscard]] std::string withoutArmParameters(const std::string& text, const YamlNode& arm,
                                               const std::vector<std::string>& names);

}  // namespace tubeplan::app
