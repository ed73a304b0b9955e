// Tables of readings that other programs write: what trackers, robot controllers and spreadsheets export.
#pragma once

#include <string>
#include <string_view>

#include "tubesheets/text_table.hpp"

namespace tubeplan::app {

using ForeignRow = tubesheets::CsvRow;

/// One table of a text and the file that it stands in, for messages.
struct ForeignTable : tubesheets::TextTable {
  std::string file;
};

/// A table whose rows are known by their numbers (tubesheets/text_table.hpp). Throws InputError for its faults.
[[nodiscard]] ForeignTable parseForeignTable(std::string_view text, const std::string& file);

}  // namespace tubeplan::app
