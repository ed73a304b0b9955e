// Reader of foreign tables of measurements: points of a tracker with a log of the joints, or one table with both.
#pragma once

#include <string>
#include <vector>

#include "app/formats/foreign/foreign_columns.hpp"

namespace tubeplan::app {

struct ForeignRequest {
  std::vector<ForeignTable> tables;
  ColumnChoice choice;
  /// Kind of measurements if the table states none; by default position if coordinates exist, otherwise touch.
  std::string kind;
};

struct ForeignMeasurements {
  std::string text;                   ///< text of a measurement table as in docs/files.md
  std::vector<std::string> taken;     ///< source of each column, "x_mm: X [mm] of points.txt", and remarks on values
  std::vector<std::string> left_out;  ///< unused columns and rows, one sentence each
  std::vector<std::string> origins;   ///< source of each measurement: "log.csv:9", or "log.csv:9 and points.txt:4"
};

/// Returns measurements, each from a row of the table that has the joints and from the matching rows of all other
/// tables. Rows match by name if both tables have names, otherwise by order if both have the same number of rows.
/// Groups before a tracker's names (A::Group::P1) are ignored. The ids of measurements are the table's ids, otherwise
/// the point names if they are unique, otherwise running numbers. Rows without coordinates are lost points and are
/// skipped, unless a column states their kind. Throws InputError in the cases of takeColumns(), for tables that do not
/// match, and for fields that should be numbers but are not. The measurements themselves are checked by
/// parseMeasurementTable().
[[nodiscard]] ForeignMeasurements readForeign(const ForeignRequest& request, const deflection::Arm& arm);

}  // namespace tubeplan::app
