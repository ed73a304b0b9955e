// What a heading of a foreign table says: a name, and the unit where it states one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/formats/units.hpp"

namespace tubeplan::app {

struct ForeignHeading {
  std::string name;            ///< small letters and digits only: "Joint 1 [deg]" is "joint1"
  const Unit* unit = nullptr;  ///< null where it states none
  bool is_count = false;       ///< of an encoder's pulses, which have no unit
};

/// The unit of that word or sign: "mm", "Millimeters", "inches", "°", "gon", which no file of the program has; null
/// where it is none.
[[nodiscard]] const Unit* findUnitWord(std::string_view word);
[[nodiscard]] bool isUnitWord(std::string_view word);

/// The unit where it is one of that kind: of an angle `h` are hours too. Null where it is none.
[[nodiscard]] const Unit* unitOfKind(const Unit* unit, UnitKind kind);

/// Angles in sixtieths of hours ("hms") and of degrees ("dms"), whose numbers parseSexagesimal() reads.
[[nodiscard]] const Unit* sixtiethsOfHours();
[[nodiscard]] const Unit* sixtiethsOfDegrees();

/// The unit of the program's files that such numbers are written in, and what they are multiplied by: gon become deg,
/// and so do hours.
struct OwnUnit {
  const Unit* unit = nullptr;
  double factor = 1;
};
[[nodiscard]] OwnUnit ownUnitOf(const Unit& unit);

/// The names of all units of a kind that findUnitWord() finds by them.
[[nodiscard]] std::vector<std::string> foreignUnitNames(UnitKind kind);

/// A unit stands in brackets, or behind the last blank, underscore, comma or slash.
[[nodiscard]] ForeignHeading parseHeading(std::string_view text);

}  // namespace tubeplan::app
