// Tables of readings that other programs write: what trackers, robot controllers and spreadsheets export.
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
  std::string line;  ///< that states it
};

/// One table of a text and the file that it stands in, for messages.
struct ForeignTable : tubesheets::TextTable {
  std::string file;
  std::map<UnitKind, StatedUnit> units;  ///< stated by lines of their own, for columns whose headings state none
  std::vector<std::string> remarks;      ///< what was made of the file's numbers, a sentence each
};

/// Returns whether a field stands for nothing, in tables that leave none empty: "-", "NaN", "n/a".
[[nodiscard]] bool isBlankField(std::string_view field);

/// Returns a table whose rows are known by their numbers (tubesheets/text_table.hpp), with the units that the lines
/// around it state; of a telescope's pointing data what parsePointingData() makes of them. Throws InputError for its
/// faults.
[[nodiscard]] ForeignTable parseForeignTable(std::string_view text, const std::string& file);

}  // namespace tubeplan::app
