#include "app/workbench/model_files.hpp"

#include "app/files/yaml/yaml_edit.hpp"

namespace tubeplan::app {

std::vector<TextFile> cellFiles(const Cell& cell, const std::filesystem::path& out) {
  std::vector<TextFile> files;
  std::string text = cellTextAt(cell, out);
  if (!cell.arm_source.text.empty()) {
    const std::string name = out.stem().string() + "-arm.yaml";
    files.push_back({std::filesystem::path(out).replace_filename(name), cell.arm_source.text});
    text = withYamlValue(text, "arm", '"' + name + '"');
  }
  files.push_back({out, text});
  return files;
}

}  // namespace tubeplan::app
