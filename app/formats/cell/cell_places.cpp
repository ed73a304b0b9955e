#include "app/formats/cell/cell_places.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string_view>
#include <system_error>

#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/origin.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLookedThrough = 64 * 1024;  // number of bytes that are searched at the beginning of a file

/// Returns true if the key `arm` begins a line or, in a file that is a flow map, follows a brace or a comma. Arm, scene
/// and sheet files have no such key. Cell files with errors are also recognised, because only this key is examined.
bool isLikeACell(std::string_view text) {
  const auto isQuote = [&](std::size_t at) { return at < text.size() && (text[at] == '"' || text[at] == '\''); };
  const auto first = text.find_first_not_of(" \t\r\n");
  const bool is_braced = first != std::string_view::npos && text[first] == '{';
  for (auto at = text.find("arm"); at != std::string_view::npos; at = text.find("arm", at + 1)) {
    const std::size_t begin = at > 0 && isQuote(at - 1) ? at - 1 : at;
    const auto colon = text.find_first_not_of(" \t", isQuote(at + 3) ? at + 4 : at + 3);
    if (colon == std::string_view::npos || text[colon] != ':') continue;
    if (begin == 0 || text[begin - 1] == '\n') return true;
    const auto before = text.find_last_not_of(" \t\r\n", begin - 1);
    if (is_braced && before != std::string_view::npos && (text[before] == '{' || text[before] == ',')) return true;
  }
  return false;
}

std::string beginningOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string beginning(kLookedThrough, '\0');
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(file.gcount()));
  return beginning;
}

bool isFilled(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && fs::file_size(path, error) > 0;
}

/// Allows overwriting `file`, an input of the command, if `out` is the cell's own file.
void allowInPlace(const Cell& cell, const fs::path& out, const std::string& file) {
  std::error_code error;
  auto* record = InputRecord::current();
  if (record && fs::equivalent(out, cell.path, error)) record->allowReplacing(file);
}

constexpr const char* kOtherName = "choose another name, because that file would be overwritten";

void requireCellOrNothing(const fs::path& cell, const std::string& option) {
  if (isFilled(cell) && !isCellFile(cell))
    throw InputError::problem(option, fmt::format("'{}' already exists and is not a cell", cell.string()), kOtherName);
}

void requireOwnArmOrNothing(const fs::path& cell, const std::string& option) {
  const fs::path arm = armPathFor(cell);
  if (isFilled(arm) && beginningOf(cell).find(arm.filename().string()) == std::string::npos)
    throw InputError::problem(
        option,
        fmt::format("the arm would be written as '{}', which already exists and is not the arm of '{}'", arm.string(),
                    cell.string()),
        kOtherName);
}

}  // namespace

bool isCellFile(const fs::path& file) { return isLikeACell(beginningOf(file)); }

fs::path armPathFor(const fs::path& cell) {
  fs::path arm = cell;
  arm.replace_filename(cell.stem().string() + "-arm.yaml");
  return arm;
}

void requireReplaceable(const fs::path& cell, bool has_arm_file, const std::string& option) {
  requireCellOrNothing(cell, option);
  if (has_arm_file) requireOwnArmOrNothing(cell, option);
}

void checkWritableCell(const Cell& cell, const fs::path& out, const std::string& option) {
  allowInPlace(cell, out, cell.path);
  checkWritableFile(out, option);
  requireCellOrNothing(out, option);
}

void checkWritableCellAndArm(const Cell& cell, const fs::path& out, const std::string& option) {
  checkWritableCell(cell, out, option);
  if (cell.arm_source.text.empty()) return;
  allowInPlace(cell, out, cell.arm_path);
  checkWritableFile(armPathFor(out), option);
  requireOwnArmOrNothing(out, option);
}

}  // namespace tubeplan::app
