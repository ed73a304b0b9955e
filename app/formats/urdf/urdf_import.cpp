#include "app/formats/urdf/urdf_import.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/formats/arm/arm_writer.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "app/formats/yaml/yaml_text.hpp"

namespace tubeplan::app {

const Units& urdfUnits() {
  static const Units kUnits(
      parseYaml("units: {length: m, angle: deg, force: N, temperature: degC, time: s}", "units").at("units"));
  return kUnits;
}

ImportedUrdf importUrdf(const std::string& text, const std::string& file, const std::string& tip) {
  ImportedUrdf imported{parseUrdf(text, file, tip), ""};
  imported.arm = fmt::format("# From {}: rigid; add joint_stiffness and beam where it is compliant.\n{}",
                             std::filesystem::path(file).filename().string(), armYaml(imported.read.arm, urdfUnits()));
  return imported;
}

std::string cellOfUrdf(const UrdfArm& read, const std::string& arm_file) {
  std::string text = fmt::format("name: {}\narm: {}\nbase: {{position: [0, 0, 0], rpy: [0, 0, 0], known: false}}\n",
                                 yamlName(read.arm.name.empty() ? "robot" : read.arm.name), yamlName(arm_file));
  if (read.shapes.empty()) return text;
  text += "link_shapes:\n";
  for (const auto& row : read.arm.rows) {
    std::string shapes;
    for (const auto& shape : read.shapes)
      if (shape.row == row.name) shapes += fmt::format("    - {}\n", shape.text);
    if (!shapes.empty()) text += fmt::format("  {}:\n{}", yamlName(row.name), shapes);
  }
  return text;
}

}  // namespace tubeplan::app
