// Detection of holes whose names contradict their positions in a map. Such typing errors would send the tool to the
// wrong tube.
#pragma once

#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

struct MisnamedHole {
  int tube = -1;              ///< index of the hole in Sheet::tubes
  double x = 0, y = 0;        ///< position expected from the other holes of the same row [m]
  int tube_at_position = -1;  ///< index in Sheet::tubes of the hole at the expected position; -1 if there is none
};

/// Finds the holes that are at least half a pitch away from the position implied by their column number and the other
/// holes of their row. The result is in sheet order. Columns are assumed to be a constant step apart; rows may begin
/// anywhere. If there are more than a few, the map probably numbers its columns differently, and the result is empty.
/// The sheet must have no problems.
[[nodiscard]] std::vector<MisnamedHole> findMisnamedHoles(const Sheet& sheet);

}  // namespace tubeplan::tubesheets
