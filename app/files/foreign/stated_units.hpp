// The units that the lines above a foreign table state: "// Units: Inches".
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/units.hpp"

namespace tubeplan::app {

struct StatedUnit {
  const Unit* unit = nullptr;
  std::string line;  ///< that states it
};

/// Returns whether a line states units and nothing else.
[[nodiscard]] bool statesUnits(std::string_view line);

/// Returns the units that lines state by the word unit or units, a colon or an equals sign, and nothing but units
/// behind it. Throws InputError where two lines differ.
[[nodiscard]] std::map<UnitKind, StatedUnit> statedUnits(const std::vector<std::string>& lines,
                                                         const std::string& file);

}  // namespace tubeplan::app
