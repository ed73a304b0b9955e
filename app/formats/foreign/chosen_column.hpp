// What a user says that a column of foreign tables is: "x_mm=X", "theta1_deg=log.csv:S*-0.00012".
#pragma once

#include <string>
#include <vector>

#include "app/formats/foreign/foreign_columns.hpp"

namespace tubeplan::app {

struct ChosenColumn {
  std::size_t target = 0;  ///< index in columnTargets()
  std::size_t table = 0, column = 0;
  const Unit* unit = nullptr;  ///< null where the name states none
  double factor = 1;           ///< of the numbers: behind the column, * and a factor or / and a divisor
};

/// Throws InputError for a name that readings have not and for a column that is not there or there twice.
[[nodiscard]] ChosenColumn parseChosenColumn(const std::string& chosen, const std::vector<ForeignTable>& tables,
                                             const std::vector<ColumnTarget>& targets);

}  // namespace tubeplan::app
