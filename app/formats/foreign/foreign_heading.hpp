// Headings of foreign tables: a name and, if stated, a unit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/formats/units.hpp"

namespace tubeplan::app {

struct ForeignHeading {
  std::string name;  ///< name in lower-case letters and digits, without the unit: "joint1" for "Joint 1 [deg]"
  const Unit* unit = nullptr;  ///< unit that the heading states; null if there is none
  bool is_count = false;       ///< true for encoder pulses, which cannot be converted to a unit
};

/// Returns the unit that a word or sign denotes: "mm", "Millimeters", "inches", "°", "gon" (which Tubeplan's own files
/// do not have); null for any other word.
[[nodiscard]] const Unit* findUnitWord(std::string_view word);
[[nodiscard]] bool isUnitWord(std::string_view word);

/// Returns `unit` if it is of the given kind, otherwise null. For angles, `h` means hours of angle instead of time.
[[nodiscard]] const Unit* unitOfKind(const Unit* unit, UnitKind kind);

/// Return the units "hms" and "dms" of sexagesimal angles in hours and in degrees, which parseSexagesimal() parses.
[[nodiscard]] const Unit* sixtiethsOfHours();
[[nodiscard]] const Unit* sixtiethsOfDegrees();

/// Unit in Tubeplan's files that replaces a foreign unit, and the conversion factor: gon and hours become degrees.
struct OwnUnit {
  const Unit* unit = nullptr;
  double factor = 1;
};
[[nodiscard]] OwnUnit ownUnitOf(const Unit& unit);

/// Returns the names of all units of the given kind that findUnitWord() recognises.
[[nodiscard]] std::vector<std::string> foreignUnitNames(UnitKind kind);

/// Parses a heading; its unit is in brackets or follows the last blank, underscore, comma or slash.
[[nodiscard]] ForeignHeading parseHeading(std::string_view text);

}  // namespace tubeplan::app
