// What a heading of a foreign table says: a name, and the unit where it states one.
#pragma once

#include <string>
#include <string_view>

#include "app/files/units.hpp"

namespace tubeplan::app {

struct ForeignHeading {
  std::string name;            ///< small letters and digits only: "Joint 1 [deg]" is "joint1"
  const Unit* unit = nullptr;  ///< null where it states none
};

/// The unit of that word or sign: "mm", "Millimeters", "inches", "°"; null where it is none.
[[nodiscard]] const Unit* findUnitWord(std::string_view word);
[[nodiscard]] bool isUnitWord(std::string_view word);

/// A unit stands in brackets, or behind the last blank, underscore, comma or slash.
[[nodiscard]] ForeignHeading parseHeading(std::string_view text);

}  // namespace tubeplan::app
