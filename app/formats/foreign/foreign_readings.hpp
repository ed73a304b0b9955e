// Reader of foreign tables of readings: a tracker's points with a log of the joints, or one table with both.
#pragma once

#include <string>
#include <vector>

#include "app/formats/foreign/foreign_columns.hpp"

namespace tubeplan::app {

struct ForeignRequest {
  std::vector<ForeignTable> tables;
  ColumnChoice choice;
  std::string kind;  ///< kind of readings if the table names none; empty: position with coordinates, else touch
};

struct ForeignReadings {
  std::string text;                   ///< a measurement table as in docs/files.md
  std::vector<std::string> taken;     ///< sources of the columns: "x_mm: X [mm] of points.txt"; remarks on their values
  std::vector<std::string> left_out;  ///< unused columns and rows, a sentence each
  std::vector<std::string> origins;   ///< source of each row: "log.csv:9", or "log.csv:9 and points.txt:4"
};

/// Returns readings from the rows of the table with the joints and the matching rows of all other tables. Rows match by
/// their names if both tables have names, else by their order if they are equally many; groups before a tracker's names
/// (A::Group::P1) are ignored. The ids of readings are those of the rows, else their points' names if these differ,
/// else running numbers. Rows without any coordinate are lost points and left out, unless a column states their kind.
/// Throws InputError as takeColumns() does, for tables that do not match and for fields that should be numbers.
/// parseMeasurementTable() checks the readings themselves.
[[nodiscard]] ForeignReadings readForeign(const ForeignRequest& request, const deflection::Arm& arm);

}  // namespace tubeplan::app
