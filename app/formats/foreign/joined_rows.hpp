// Which rows of foreign tables are of one reading.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/formats/foreign/foreign_table.hpp"

namespace tubeplan::app {

struct JoinedRows {
  std::vector<std::vector<std::size_t>> rows;  ///< row k of the readings is row rows[t][k] of table t
  std::size_t lead = 0;                        ///< the table that the others follow
  std::string how;                             ///< "by name", "row by row"; empty of one table
  std::vector<std::string> left_out;           ///< rows without partners, a sentence for each table
};

/// The rows of the leading table, and beside them those of every other: by names where both have a column of names,
/// else in their order, for which there must be as many. Throws InputError for tables that do not go together.
[[nodiscard]] JoinedRows joinRows(const std::vector<ForeignTable>& tables, std::size_t lead,
                                  const std::vector<std::optional<std::size_t>>& names);

/// A point's name without the groups before it: "A::Group::P1" is "P1".
[[nodiscard]] std::string pointName(const std::string& field);

}  // namespace tubeplan::app
