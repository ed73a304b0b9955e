// Tables of measurements from other programs: exports of trackers, robot controllers and spreadsheets.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/formats/units.hpp"
#include "tubesheets/text_table.hpp"

namespace tubeplan::app {

using ForeignRow = tubesheets::CsvRow;

struct StatedUnit {
  const Unit* unit = nullptr;
  std::string line;  ///< line of the file that states the unit
};

/// Table parsed from the text of another program, with the file's name for messages.
struct ForeignTable : tubesheets::TextTable {
  std::string file;
  std::map<UnitKind, StatedUnit> units;  ///< units stated by separate lines, for columns whose headings state none
  std::vector<std::string> remarks;      ///< remarks on the conversion of the file's numbers, one sentence each
};

/// Returns true for a field that means "no value": "-", "NaN", "n/a".
[[nodiscard]] bool isBlankField(std::string_view field);

/// Parses the table in `text`, which is found by its rows of numbers (tubesheets/text_table.hpp), and the units stated
/// in lines around it. Pointing data of telescopes are converted by parsePointingData(). Throws InputError if there is
/// no valid table.
[[nodiscard]] ForeignTable parseForeignTable(std::string_view text, const std::string& file);

}  // namespace tubeplan::app
