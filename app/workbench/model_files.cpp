#include "app/workbench/model_files.hpp"

namespace tubeplan::app {

std::vector<TextFile> cellFiles(const Cell& cell, const std::filesystem::path& out) {
  std::string text = cellTextAt(cell, out);
  if (cell.arm_source.text.empty()) return {{out, text}};
  TextFile arm{std::filesystem::path(out).replace_filename(out.stem().string() + "-arm.yaml"), cell.arm_source.text};
  makePair(text, arm);
  return {{out, text}, arm};
}

}  // namespace tubeplan::app
