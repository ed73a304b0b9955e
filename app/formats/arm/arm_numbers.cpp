#include "app/formats/arm/arm_numbers.hpp"

#include <fmt/format.h>

#include <cassert>

#include "app/formats/yaml/strict_yaml.hpp"
#include "app/formats/yaml/yaml_edit.hpp"
#include "deflection/row_numbers.hpp"

namespace tubeplan::app {

namespace {

/// Returns the row with the given name among the links of the arm or of its side chains; null if there is none.
const YamlNode* findRow(const YamlNode& node, std::string_view name) {
  if (const YamlNode* links = node.find("links"))
    for (const YamlNode& row : links->items) {
      const YamlNode* row_name = row.find("name");
      if (row_name && row_name->scalar == name) return &row;
    }
  if (const YamlNode* chains = node.find("side_chains"))
    for (const YamlNode& chain : chains->items)
      if (const YamlNode* row = findRow(chain, name)) return row;
  return nullptr;
}

bool isToolKey(std::string_view number_name) {
  return number_name.starts_with("tip") || number_name.starts_with("turn") || number_name == "axis";
}

// Converts the part of a parameter's dotted name after the row or tool to a path in the file: vector components become
// indices such as [0], and a lump becomes the weight of the lump.
std::string pathBelow(std::string_view number_name) {
  constexpr std::string_view kLumps = "weight.lumps.";
  if (number_name.starts_with(kLumps))
    return fmt::format("weight.lumps[{}].weight", std::stoi(std::string(number_name.substr(kLumps.size()))) - 1);
  const std::size_t dot = number_name.rfind('.');
  const std::string_view parent = number_name.substr(0, dot == std::string_view::npos ? 0 : dot);
  if (parent == "tip" || parent == "origin.position")
    return fmt::format("{}[{}]", parent, std::string_view("xyz").find(number_name.back()));
  if (parent == "origin.rpy") return fmt::format("origin.rpy[{}]", std::string_view("rpy").find(number_name.back()));
  return std::string(number_name);
}
}  // namespace

const YamlNode& findArmNode(const YamlNode& arm, std::string_view name) {
  const std::string path = armPath(arm, name);
  const YamlNode* best = &arm;
  for (std::size_t end = 0; end < path.size(); ++end) {
    if (end + 1 < path.size() && path[end + 1] != '.' && path[end + 1] != '[') continue;
    const std::string_view part = std::string_view(path).substr(0, end + 1);
    if (const YamlNode* node = findNode(arm, part)) best = node;
  }
  return *best;
}

std::string armPath(const YamlNode& arm, std::string_view name) {
  const std::string prefix = arm.path.empty() ? "" : arm.path + ".";
  const std::size_t dot = name.find('.');
  const std::string_view first = name.substr(0, dot);
  const std::string_view number_name = dot == std::string_view::npos ? "" : name.substr(dot + 1);
  // A row may also be named `tool`; only the names tip, turn and axis always refer to the arm's tool.
  const YamlNode* row = first == "tool" && isToolKey(number_name) ? nullptr : findRow(arm, first);
  if (row) return number_name.empty() ? row->path : row->path + "." + pathBelow(number_name);
  return arm.find(first) ? prefix + std::string(first) + (number_name.empty() ? "" : "." + pathBelow(number_name)) : "";
}

std::string withArmParameters(const std::string& text, const YamlNode& arm, const ArmSource& source,
                              const std::vector<std::pair<std::string, double>>& parameters) {
  std::string out = text;
  for (const auto& [name, value] : parameters) {
    const auto parameter = deflection::findParameter(source.arm, name);
    assert(parameter.has_value());
    out = withYamlValue(out, armPath(arm, name),
                        formatNumber(source.units.toFile(value, dimensionOf(parameter->quantity))));
  }
  return out;
}

std::string withoutArmParameters(const std::string& text, const YamlNode& arm, const std::vector<std::string>& names) {
  std::string out = text;
  for (const auto& name : names) out = withoutYamlValue(out, armPath(arm, name));
  return out;
}

}  // namespace tubeplan::app
