// A table's own text with columns added or changed; everything else stays byte for byte.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tubesheets/text_table.hpp"

namespace tubeplan::tubesheets {

/// New content of a column.
struct ColumnText {
  std::string name;
  std::optional<std::size_t> place;  ///< index of the existing column; a new one is added at the end if this is empty
  /// New fields by line number; other rows keep theirs, or are empty in a new column.
  std::map<int, std::string> fields;
};

/// Returns the text that the table was read from, with those columns changed or added. Comments, order, line ends,
/// quotes, separators, units and the fields of other columns are kept. A field that already has the same value stays as
/// it is written.
[[nodiscard]] std::string withColumns(std::string_view text, const TextTable& table,
                                      const std::vector<ColumnText>& columns);

}  // namespace tubeplan::tubesheets
