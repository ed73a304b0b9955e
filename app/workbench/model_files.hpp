// A model of the workbench as the files that the commands read.
#pragma once

#include <filesystem>
#include <vector>

#include "app/files/cell_writer.hpp"

namespace tubeplan::app {

/// The cell at that place, its arm beside it where that stands in a file of its own; the cell is the first.
[[nodiscard]] std::vector<TextFile> cellFiles(const Cell& cell, const std::filesystem::path& out);

}  // namespace tubeplan::app
