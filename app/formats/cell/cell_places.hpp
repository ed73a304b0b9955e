// Output paths of cells, and checks of the files that would be overwritten.
#pragma once

#include <filesystem>
#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Returns true if a file has a key `arm`, which marks it as a cell even if it has errors.
[[nodiscard]] bool isCellFile(const std::filesystem::path& file);

/// Returns the path for the arm file of a new cell: in the cell's folder, with the cell's name and "-arm".
[[nodiscard]] std::filesystem::path armPathFor(const std::filesystem::path& cell);

/// Throws InputError if a new cell would overwrite a file that is not a cell. Also throws InputError if its arm would
/// overwrite an arm file that the replaced cell does not name, because other cells may use that file.
void requireReplaceable(const std::filesystem::path& cell, bool has_arm_file, const std::string& option);

/// Throws InputError unless `out` can be written (checkWritableFile()) and is a new file or a cell; the input `cell`
/// itself is allowed. For use before a long computation.
void checkWritableCell(const Cell& cell, const std::filesystem::path& out, const std::string& option);

/// Checks `out` as in checkWritableCell() and, if the arm has its own file, the path of the new arm file in the folder
/// of `out`. Throws InputError.
void checkWritableCellAndArm(const Cell& cell, const std::filesystem::path& out, const std::string& option);

}  // namespace tubeplan::app
