// Tables that other programs and people write: what trackers, controllers, inspection programs and spreadsheets export.
// Text only: files are read elsewhere.
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

/// A reader's knowledge of the words of its tables.
struct TableWords {
  bool (*isUnit)(std::string_view) = nullptr;  ///< true for a unit in the row of units below the headings
  /// Ranks a row as a heading: the heading is the first whole one, else the first partial one. If empty, the heading is
  /// the line above the first row with a number.
  std::function<HeadingRank(const std::vector<std::string>&)> rankHeading = nullptr;
  /// True for a line that states units and is neither row nor heading.
  bool (*statesUnits)(std::string_view) = nullptr;
};

/// One table of a text, with the decimal point of the program.
struct TextTable {
  /// Column names, as many as the fields of a row; "column 1", ... without a heading.
  std::vector<std::string> columns;
  bool has_heading = false;
  int heading_line = 0;  ///< 0 if there is none
  /// Line of a row of units, whose words are added to the headings in brackets; 0 if there is none.
  int units_line = 0;
  char separator = ',';  ///< a blank stands for any number of blanks and tabs
  std::vector<CsvRow> rows;
  std::vector<std::string> lines_before;  ///< text before the table: all comments, then lines of units
  std::optional<Problem> problem;         ///< first fault; the other members are then not to be used
};

/// Reads a table whose fields are separated by tab, semicolon, comma or |, or by blanks if its rows are recognised by
/// their numbers. The decimal sign is a point or, if commas do not separate fields, a comma. A table with a heading
/// known to the reader begins below it and may have one column. Any other table begins with the first line from which
/// all lines have as many fields; its heading is the line before, if that has as many and no numbers. A table may have
/// a row of units below its heading, or its heading in a comment. Empty lines and lines that begin with #, // or % are
/// no rows. Faults: no table, a row longer or shorter than the others, a quote that is not closed, a zero byte, numbers
/// that may have thousands separators.
[[nodiscard]] TextTable parseTextTable(std::string_view text, const TableWords& words);

/// A column's plain name and its unit as written: "Joint 1 [deg]" gives "joint1" and "deg".
struct HeadingWords {
  std::string name;  ///< small letters and digits of ASCII, and all other characters beyond ASCII
  std::string unit;  ///< unit as written; empty if none is stated
};

/// Splits a heading into name and unit. A unit stands in brackets, or after the last blank, underscore, comma or slash.
[[nodiscard]] HeadingWords splitHeading(std::string_view text, bool (*isUnit)(std::string_view));

/// Returns the small letters and digits of ASCII and everything beyond ASCII: "Tube ID" gives "tubeid".
[[nodiscard]] std::string plainName(std::string_view text);

/// Returns the text after "unit:" or "units =" in a line; empty if there is none.
[[nodiscard]] std::string_view behindUnits(std::string_view line);

/// Returns the unit that a line before the table states for all of it: "Units: Inches" gives "Inches"; empty if there
/// is none.
[[nodiscard]] std::string statedUnit(const std::vector<std::string>& lines_before, bool (*isUnit)(std::string_view));

}  // namespace tubeplan::tubesheets
