// Columns of foreign tables that the user assigns to quantities: "x_mm=X", "theta1_deg=log.csv:S*-0.00012".
#pragma once

#include <string>
#include <vector>

#include "app/formats/foreign/foreign_columns.hpp"

namespace tubeplan::app {

struct ChosenColumn {
  std::size_t target = 0;  ///< index of the quantity in columnTargets()
  std::size_t table = 0, column = 0;
  const Unit* unit = nullptr;  ///< unit of the column's numbers; null if the name states none
  double factor = 1;           ///< factor for the column's numbers, from * FACTOR or / DIVISOR after the column
};

/// Parses an assignment of a column. Throws InputError for an unknown quantity and for a column that is missing or
/// occurs twice.
[[nodiscard]] ChosenColumn parseChosenColumn(const std::string& chosen, const std::vector<ForeignTable>& tables,
                                             const std::vector<ColumnTarget>& targets);

}  // namespace tubeplan::app
