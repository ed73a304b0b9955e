// Parser for tables from other programs or written by hand, such as exports of trackers, controllers, inspection
// programs and spreadsheets. This module does not open files.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/csv_table.hpp"

namespace tubeplan::tubesheets {

/// Confidence that a row of fields is the heading of a table.
enum class HeadingRank { kNone, kPartial, kWhole };

/// Callbacks that recognise the headings and units of a reader's tables.
struct TableWords {
  bool (*isUnit)(std::string_view) = nullptr;  ///< returns true for a unit in the row of units below the heading
  /// Ranks how likely a row is the heading. The heading is the first row of rank kWhole, else the first of rank
  /// kPartial. If this function is not set, the heading is the line above the first row with a number.
  std::function<HeadingRank(const std::vector<std::string>&)> rankHeading = nullptr;
  /// Returns true for a line that states units and is neither a row nor a heading.
  bool (*statesUnits)(std::string_view) = nullptr;
};

/// A table parsed from text, with decimal commas replaced by points.
struct TextTable {
  /// Column names, one for each field of a row; "column 1", "column 2", ... if there is no heading.
  std::vector<std::string> columns;
  bool has_heading = false;
  int heading_line = 0;  ///< line number of the heading, from 1; 0 if there is none
  /// Line number of a row of units, which are added to the column names in brackets; 0 if there is none.
  int units_line = 0;
  char separator = ',';  ///< field separator; a blank represents any number of blanks and tabs
  std::vector<CsvRow> rows;
  /// Lines outside the rows: all comments, lines above the table, then lines that state units.
  std::vector<std::string> lines_before;
  std::optional<Problem> problem;  ///< first error; the other members are valid only if there is none
};

/// Reads a table whose fields are separated by tab, semicolon, comma or |, or by blanks if `words.rankHeading` is not
/// set. The decimal sign is a point or, if commas do not separate fields, a comma. A table with a heading known to the
/// reader begins below the heading and may have only one column. Any other table begins with the first line from which
/// all lines have the same number of fields; its heading is the line before, if that line has the same number of fields
/// and no numbers. A table may have a row of units below its heading, or its heading in a comment. Empty lines and
/// lines that begin with #, // or % are not rows. Sets `problem` if there is no table, or for a row with more or fewer
/// fields than other rows, a quote that is not closed, a zero byte, or numbers that may have thousands separators.
[[nodiscard]] TextTable parseTextTable(std::string_view text, const TableWords& words);

/// Name and unit of a column heading: "Joint 1 [deg]" gives "joint1" and "deg".
struct HeadingWords {
  std::string name;  ///< name in the form of plainName()
  std::string unit;  ///< unit as written; empty if no unit is stated
};

/// Splits a heading into name and unit. The unit may be in brackets, or after the last blank, underscore, comma or
/// slash.
[[nodiscard]] HeadingWords splitHeading(std::string_view text, bool (*isUnit)(std::string_view));

/// Returns the text in lower case, without ASCII characters other than letters and digits: "Tube ID" gives "tubeid".
[[nodiscard]] std::string plainName(std::string_view text);

/// Returns the text after "unit:" or "units =" in a line; empty if the line has no such text.
[[nodiscard]] std::string_view behindUnits(std::string_view line);

/// Returns the unit that a line before the table states for the whole table: "Units: Inches" gives "Inches"; empty if
/// no line does.
[[nodiscard]] std::string statedUnit(const std::vector<std::string>& lines_before, bool (*isUnit)(std::string_view));

}  // namespace tubeplan::tubesheets
