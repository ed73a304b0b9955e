// Matching of the rows of foreign tables that belong to one reading.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/formats/foreign/foreign_table.hpp"

namespace tubeplan::app {

struct JoinedRows {
  std::vector<std::vector<std::size_t>> rows;  ///< matching rows: reading k has row rows[t][k] of table t
  std::size_t lead = 0;                        ///< table whose rows the others match
  std::string how;                             ///< way of matching: "by name", "row by row"; empty for one table
  std::vector<std::string> left_out;           ///< rows without a match, a sentence for each table
};

/// Matches the rows of every table with those of the leading one: by name if both have a column of names, else by order
/// if they are equally many. Throws InputError for tables that do not match.
[[nodiscard]] JoinedRows joinRows(const std::vector<ForeignTable>& tables, std::size_t lead,
                                  const std::vector<std::optional<std::size_t>>& names);

/// Returns a point's name without the groups before it: "P1" of "A::Group::P1".
[[nodiscard]] std::string pointName(const std::string& field);

}  // namespace tubeplan::app
