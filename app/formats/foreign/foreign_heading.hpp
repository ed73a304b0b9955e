// Headings of foreign tables: a name, and the unit if the heading states one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/formats/units.hpp"

namespace tubeplan::app {

struct ForeignHeading {
  std::string name;            ///< name in lower-case letters and digits: "joint1" for "Joint 1 [deg]"
  const Unit* unit = nullptr;  ///< stated unit; null if there is none
  bool is_count = false;       ///< true for counts of encoder pulses, which have no unit
};

/// Returns the unit of a word or sign: "mm", "Millimeters", "inches", "°", "gon" (which the program's own files do not
/// have); null if it is none.
[[nodiscard]] const Unit* findUnitWord(std::string_view word);
[[nodiscard]] bool isUnitWord(std::string_view word);

/// Returns the unit if it is of that kind, else null. For angles, `h` means hours of angle.
[[nodiscard]] const Unit* unitOfKind(const Unit* unit, UnitKind kind);

/// Returns the unit of angles in sixtieths of hours ("hms") or of degrees ("dms"), whose numbers parseSexagesimal()
/// reads.
[[nodiscard]] const Unit* sixtiethsOfHours();
[[nodiscard]] const Unit* sixtiethsOfDegrees();

/// Unit in the program's files for numbers of a foreign unit, and their factor: gon and hours become deg.
struct OwnUnit {
  const Unit* unit = nullptr;
  double factor = 1;
};
[[nodiscard]] OwnUnit ownUnitOf(const Unit& unit);

/// Returns the names of all units of a kind that findUnitWord() knows.
[[nodiscard]] std::vector<std::string> foreignUnitNames(UnitKind kind);

/// Parses a heading, whose unit is in brackets or after the last blank, underscore, comma or slash.
[[nodiscard]] ForeignHeading parseHeading(std::string_view text);

}  // namespace tubeplan::app
