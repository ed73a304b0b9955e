// Tables that other programs write: what trackers, robot controllers and spreadsheets export.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/foreign/stated_units.hpp"

namespace tubeplan::app {

struct ForeignRow {
  int line = 0;  ///< from 1
  std::vector<std::string> fields;
};

/// One table of a text, with the decimal point of the program.
struct ForeignTable {
  std::string file;                  ///< for messages
  std::vector<std::string> columns;  ///< as many as every row has fields; "column 1", ... where there is no heading
  bool has_heading = false;
  int heading_line = 0;
  std::vector<ForeignRow> rows;
  std::vector<std::string> lines_before;  ///< of text before the table, comments among them
  std::map<UnitKind, StatedUnit> units;   ///< that those lines state, of columns whose headings state none
};

/// Whether a field stands for nothing, in tables that leave none empty: "-", "NaN", "n/a".
[[nodiscard]] bool isBlankField(std::string_view field);

/// Fields apart by tab, semicolon, comma or blanks, whichever makes a table of the text; with a decimal point or, where
/// fields are not apart by commas, a decimal comma. The table begins with the first line from which all have as many
/// fields, its heading is the line before where that has as many and no numbers, with the units of a line between; else
/// the last comment that has as many. Empty lines and lines that begin with #, // or % are no rows. Throws InputError
/// for text without a table, for a row that is longer or shorter than the others and for a quote that is not closed.
[[nodiscard]] ForeignTable parseForeignTable(std::string_view text, const std::string& file);

}  // namespace tubeplan::app
