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

/// How sure a row of fields is the heading of a table.
enum class HeadingRank { kNone, kPartial, kWhole };

/// What the words of a table mean to its reader.
struct TableWords {
  bool (*isUnit)(std::string_view) = nullptr;  ///< of a row of units below the headings
  /// The heading is the first whole one, else the first partial one. Left out, it is what stands above the first row
  /// with a number.
  std::function<HeadingRank(const std::vector<std::string>&)> rankHeading = nullptr;
  bool (*statesUnits)(std::string_view) = nullptr;  ///< of a line that states units and is neither row nor heading
};

/// One table of a text, with the decimal point of the program.
struct TextTable {
  std::vector<std::string> columns;  ///< as many as every row has fields; "column 1", ... where there is no heading
  bool has_heading = false;
  int heading_line = 0;  ///< 0 where there is none
  int units_line = 0;  ///< of a row of units, whose words stand behind the headings in brackets; 0 where there is none
  char separator = ',';  ///< a blank: any number of blanks and tabs
  std::vector<CsvRow> rows;
  std::vector<std::string> lines_before;  ///< of text before the table, all comments, then lines of units
  std::optional<Problem> problem;         ///< the first fault; then nothing else is to be used
};

/// Fields apart by tab, semicolon, comma or |, and where rows are known by their numbers by blanks; with a decimal
/// point or, where fields are not apart by commas, a decimal comma. A table whose heading the reader knows begins below
/// it and may have one column; any other begins with the first line from which all have as many fields, its heading the
/// line before where that has as many and no numbers. Either may have a row of units below its heading, or its heading
/// in a comment. Empty lines and lines that begin with #, // or % are no rows. Faults: no table, a row that is longer
/// or shorter than the others, a quote that is not closed, a zero byte, numbers that may have thousands apart.
[[nodiscard]] TextTable parseTextTable(std::string_view text, const TableWords& words);

/// A column's name and its unit as they are written: "Joint 1 [deg]" is "joint1" and "deg".
struct HeadingWords {
  std::string name;  ///< small letters and digits of ASCII, and whatever is beyond it
  std::string unit;  ///< empty where none is stated
};

/// A unit stands in brackets, or behind the last blank, underscore, comma or slash.
[[nodiscard]] HeadingWords splitHeading(std::string_view text, bool (*isUnit)(std::string_view));

/// Small letters and digits of ASCII, and whatever is beyond it: "Tube ID" is "tubeid".
[[nodiscard]] std::string plainName(std::string_view text);

/// Returns what stands behind "unit:" or "units =" in a line; empty where nothing does.
[[nodiscard]] std::string_view behindUnits(std::string_view line);

/// The unit that a line before the table states for all of it: "Units: Inches" is "Inches"; empty where none does.
[[nodiscard]] std::string statedUnit(const std::vector<std::string>& lines_before, bool (*isUnit)(std::string_view));

}  // namespace tubeplan::tubesheets
