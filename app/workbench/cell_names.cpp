#include "app/workbench/cell_names.hpp"

#include <fstream>
#include <string_view>

namespace tubeplan::app {

namespace {

constexpr std::size_t kLookedThrough = 64 * 1024;  // of a file, in bytes, for what it is

/// Whether a cell's key `arm` begins a line, or follows a brace or a comma in a file that is one braced mapping: arms,
/// scenes and sheets have none. Nothing else is read of it, so a cell with a fault in it counts too, and says so when
/// it is opened.
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

}  // namespace

std::vector<std::string> cellNames(const OpenedFolder& folder) {
  auto names = folder.names(".yaml");
  std::erase_if(names, [&](const std::string& name) {
    std::ifstream file(folder.path() / name, std::ios::binary);
    std::string beginning(kLookedThrough, '\0');
    file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    beginning.resize(static_cast<std::size_t>(file.gcount()));
    return !isLikeACell(beginning);
  });
  return names;
}

}  // namespace tubeplan::app
