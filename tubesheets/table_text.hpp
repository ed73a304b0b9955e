// Adds or changes columns in the text of a table; everything else is kept byte for byte.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tubesheets/text_table.hpp"

namespace tubeplan::tubesheets {

/// A column to be added to a table or changed in it.
struct ColumnText {
  std::string name;
  std::optional<std::size_t> place;  ///< index of the existing column; if empty, a new column is added at the end
  /// New fields, keyed by line number; in other rows the field is kept, or is empty in a new column.
  std::map<int, std::string> fields;
};

/// Returns the text that the table was read from, with the given columns changed or added. Comments, order, line
/// endings, quotes, separators, units and the fields of other columns are kept. A field that already has the new value
/// is kept as written.
[[nodiscard]] std::string withColumns(std::string_view text, const TextTable& table,
                                      const std::vector<ColumnText>& columns);

}  // namespace tubeplan::tubesheets
