// Detection of holes whose names do not fit their positions in a map: typing errors that would send the tool to the
// wrong tube.
#pragma once

#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

struct MisnamedHole {
  int tube = -1;        ///< index of the hole in Sheet::tubes
  double x = 0, y = 0;  ///< position expected from the other holes of the same row [m]
  int there = -1;       ///< index in Sheet::tubes of the hole at the expected position; -1 if there is none
};

/// Finds, in sheet order, the holes at least half a pitch from the position that their column number implies, given the
/// other holes of their row. Columns are assumed to be a constant step apart; rows may begin anywhere. The result is
/// empty if more than a few holes would be found, because the map then numbers its columns differently. The sheet must
/// have no problems.
[[nodiscard]] std::vector<MisnamedHole> findMisnamedHoles(const Sheet& sheet);

}  // namespace tubeplan::tubesheets
