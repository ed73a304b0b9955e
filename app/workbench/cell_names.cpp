#include "app/workbench/cell_names.hpp"

#include "app/files/cell_places.hpp"

namespace tubeplan::app {

std::vector<std::string> cellNames(const OpenedFolder& folder) {
  auto names = folder.names(".yaml");
  std::erase_if(names, [&](const std::string& name) { return !isCellFile(folder.path() / name); });
  return names;
}

}  // namespace tubeplan::app
