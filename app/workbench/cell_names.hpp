// Which files of the opened folder are cells.
#pragma once

#include <string>
#include <vector>

#include "app/workbench/opened_folder.hpp"

namespace tubeplan::app {

/// Of its YAML files those that name an arm, sorted; a cell with a fault in it is one too, and says so when it is
/// opened.
[[nodiscard]] std::vector<std::string> cellNames(const OpenedFolder& folder);

}  // namespace tubeplan::app
