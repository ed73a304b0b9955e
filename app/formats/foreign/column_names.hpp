// Identification of columns in foreign tables by their headings or, without headings, by the number of columns.
#pragma once

#include <vector>

#include "app/formats/foreign/foreign_columns.hpp"
#include "app/formats/foreign/foreign_heading.hpp"

namespace tubeplan::app {

/// Returns true if a heading names the target and has no contradictory unit: "x (deg)" is not a position. Encoder
/// pulses are valid for joints only.
[[nodiscard]] bool fits(const ColumnTarget& target, const ForeignHeading& heading);

/// Returns the unit of a column's numbers: from the heading, otherwise from a line above the table, otherwise from
/// `usual` (--units); null if it is unknown. Throws InputError if the line and `usual` state different units.
[[nodiscard]] const Unit* unitOf(const ForeignTable& table, const ForeignHeading& heading, UnitKind kind,
                                 const UsualUnits& usual);

/// Returns the headings of one table; a heading is empty if the column's content is unknown.
[[nodiscard]] std::vector<ForeignHeading> columnNames(const ForeignTable& table,
                                                      const std::vector<ColumnTarget>& targets);

/// Returns the headings of all tables, in which each joint is identified and surveyors' axes are named x, y and z.
[[nodiscard]] std::vector<std::vector<ForeignHeading>> columnNames(const std::vector<ForeignTable>& tables,
                                                                   const std::vector<ColumnTarget>& targets);

}  // namespace tubeplan::app
