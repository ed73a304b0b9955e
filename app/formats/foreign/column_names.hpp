// What the columns of foreign tables are called: by their headings, or by their shape where there are none.
#pragma once

#include <vector>

#include "app/formats/foreign/foreign_columns.hpp"
#include "app/formats/foreign/foreign_heading.hpp"

namespace tubeplan::app {

/// A heading that states a unit of another kind is of something else: "x (deg)" is no place; and pulses are of joints.
[[nodiscard]] bool fits(const ColumnTarget& target, const ForeignHeading& heading);

/// Returns the unit of a column's numbers: that of its heading, else of a line above the table, else the usual one;
/// null where none is stated. Throws InputError where the last two differ.
[[nodiscard]] const Unit* unitOf(const ForeignTable& table, const ForeignHeading& heading, UnitKind kind,
                                 const UsualUnits& usual);

/// Returns the headings of one table, empty for columns of which nothing is known.
[[nodiscard]] std::vector<ForeignHeading> columnNames(const ForeignTable& table,
                                                      const std::vector<ColumnTarget>& targets);

/// Returns the headings of every table, with the joints told apart and surveyors' axes called x, y and z.
[[nodiscard]] std::vector<std::vector<ForeignHeading>> columnNames(const std::vector<ForeignTable>& tables,
                                                                   const std::vector<ColumnTarget>& targets);

}  // namespace tubeplan::app
