// Readings out of foreign tables: a tracker's points beside a log of the joints, or one table with both.
#pragma once

#include <string>
#include <vector>

#include "app/formats/foreign/foreign_columns.hpp"

namespace tubeplan::app {

struct ForeignRequest {
  std::vector<ForeignTable> tables;
  ColumnChoice choice;
  std::string kind;  ///< of readings whose table names none; empty: position where there are coordinates, else touch
};

struct ForeignReadings {
  std::string text;                   ///< a measurement table: docs/files.md
  std::vector<std::string> taken;     ///< "x_mm: X [mm] of points.txt", and what was made of it
  std::vector<std::string> left_out;  ///< columns and rows of which nothing is taken, a sentence each
  std::vector<std::string> origins;   ///< of each row: "log.csv:9", or "log.csv:9 and points.txt:4"
};

/// The rows of the table with the joints; those of every further table go beside them by their names where both have
/// names, else in their order, for which there must be as many. Names are compared without the groups that trackers put
/// before them (A::Group::P1). Readings are called by their ids, else by their points where these differ, else counted.
/// Rows whose coordinates are all empty, of points that were lost, are left out where no column says their kind.
/// Throws InputError as takeColumns() does, for tables that do not go together and for what should be a number and is
/// none. What the readings themselves must hold is for parseMeasurementTable() to see.
[[nodiscard]] ForeignReadings readForeign(const ForeignRequest& request, const deflection::Arm& arm);

}  // namespace tubeplan::app
