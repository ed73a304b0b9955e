// Names of the columns of foreign tables: from their headings, or from the table's shape if it has none.
#pragma once

#include <vector>

#include "app/formats/foreign/foreign_columns.hpp"
#include "app/formats/foreign/foreign_heading.hpp"

namespace tubeplan::app {

/// Returns true if a heading has a name of the target and no contradictory unit: "x (deg)" is no position. Pulses are
/// valid for joints only.
[[nodiscard]] bool fits(const ColumnTarget& target, const ForeignHeading& heading);

/// Returns the unit of a column's numbers: from its heading, else from a line above the table, else the usual one; null
/// if none is stated. Throws InputError if the last two differ.
[[nodiscard]] const Unit* unitOf(const ForeignTable& table, const ForeignHeading& heading, UnitKind kind,
                                 const UsualUnits& usual);

/// Returns the headings of one table, empty for columns of unknown content.
[[nodiscard]] std::vector<ForeignHeading> columnNames(const ForeignTable& table,
                                                      const std::vector<ColumnTarget>& targets);

/// Returns the headings of every table, with each joint identified and surveyors' axes named x, y and z.
[[nodiscard]] std::vector<std::vector<ForeignHeading>> columnNames(const std::vector<ForeignTable>& tables,
                                                                   const std::vector<ColumnTarget>& targets);

}  // namespace tubeplan::app
