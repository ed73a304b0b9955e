// Output paths of cells, and checks of the files that they replace.
#pragma once

#include <filesystem>
#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Returns true if a file is a cell, also one with errors: it has a key `arm`.
[[nodiscard]] bool isCellFile(const std::filesystem::path& file);

/// Returns the path for the arm of a new cell: beside the cell, under its name and "-arm".
[[nodiscard]] std::filesystem::path armBeside(const std::filesystem::path& cell);

/// Throws InputError unless a new cell would replace a cell or nothing, and its arm's file one that the replaced cell
/// names or nothing. Other cells may use any other arm file.
void requireReplaceable(const std::filesystem::path& cell, bool has_arm_file, const std::string& option);

/// Throws InputError unless `out` can be written (checkWritableFile()) and is a new file or a cell, such as the cell
/// itself. For use before the work.
void checkWritableCell(const Cell& cell, const std::filesystem::path& out, const std::string& option);

/// Checks `out` as checkWritableCell() does, and the path of the arm's file beside it, if the arm has a file of its
/// own. Throws InputError.
void checkWritableCellAndArm(const Cell& cell, const std::filesystem::path& out, const std::string& option);

}  // namespace tubeplan::app
