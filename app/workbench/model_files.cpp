#include "app/workbench/model_files.hpp"

#include "app/files/cell_places.hpp"

namespace tubeplan::app {

std::vector<TextFile> cellFiles(const Cell& cell, const std::filesystem::path& out) {
  std::string text = cellTextAt(cell, out);
  if (cell.arm_source.text.empty()) return {{out, text}};
  TextFile arm{armBeside(out), cell.arm_source.text};
  makePair(text, arm);
  return {{out, text}, arm};
}

}  // namespace tubeplan::app
