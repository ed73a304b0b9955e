// Where cells are written, and what may be replaced there.
#pragma once

#include <filesystem>
#include <string>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Whether a file is a cell, also one with a fault in it: it names an arm.
[[nodiscard]] bool isCellFile(const std::filesystem::path& file);

/// Where the arm of a cell goes that is written here: beside it, under its name and "-arm".
[[nodiscard]] std::filesystem::path armBeside(const std::filesystem::path& cell);

/// A cell replaces a cell, and its arm's file one that the replaced cell names: other cells may be read with any other.
/// Throws InputError.
void requireReplaceable(const std::filesystem::path& cell, bool has_arm_file, const std::string& option);

/// Before the work: checkWritableFile() of `out`, which may be the cell itself.
void checkWritableCell(const Cell& cell, const std::filesystem::path& out, const std::string& option);

/// The same where the arm's file is written too, beside the cell.
void checkWritableCellAndArm(const Cell& cell, const std::filesystem::path& out, const std::string& option);

}  // namespace tubeplan::app
