// A table's own text with columns added or changed: all else stays, byte for byte.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tubesheets/text_table.hpp"

namespace tubeplan::tubesheets {

/// What a column is to say.
struct ColumnText {
  std::string name;
  std::optional<std::size_t> place;   ///< of the column that is there; behind the others where there is none
  std::map<int, std::string> fields;  ///< by line; empty of rows that are not named, and untouched where they are there
};

/// The text that the table was read from, with those columns: comments, order, line ends, quotes, separators, units and
/// everything that other columns hold are kept. A field that says the same already stays as it is written.
[[nodiscard]] std::string withColumns(std::string_view text, const TextTable& table,
                                      const std::vector<ColumnText>& columns);

}  // namespace tubeplan::tubesheets
