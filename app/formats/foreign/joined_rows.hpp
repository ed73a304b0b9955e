// Matching of rows in foreign tables that belong to the same measurement.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/formats/foreign/foreign_table.hpp"

namespace tubeplan::app {

struct JoinedRows {
  std::vector<std::vector<std::size_t>> rows;  ///< row indices: measurement k combines row rows[t][k] of each table t
  /// Index of the leading table; the rows of all other tables are matched with its rows.
  std::size_t lead = 0;
  std::string how;  ///< method of matching rows: "by name", "row by row", or both; empty for one table
  std::vector<std::string> left_out;  ///< rows without a match, one sentence for each table
};

/// Matches the rows of every table with the rows of table `lead`: by name if both tables have a column of names
/// (`names`), otherwise by order if they have the same number of rows. Throws InputError for tables that do not match.
[[nodiscard]] JoinedRows joinRows(const std::vector<ForeignTable>& tables, std::size_t lead,
                                  const std::vector<std::optional<std::size_t>>& names);

/// Returns a point's name without the groups in front: "P1" for "A::Group::P1".
[[nodiscard]] std::string pointName(const std::string& field);

}  // namespace tubeplan::app
