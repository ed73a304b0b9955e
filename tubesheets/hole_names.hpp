// A hole whose name does not fit its position in a map: a typing error that would send the tool to the wrong tube.
#pragma once

#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

struct MisnamedHole {
  int tube = -1;        ///< index in Sheet::tubes
  double x = 0, y = 0;  ///< position expected from the other holes of its row [m]
  int there = -1;       ///< index of the hole at that position; -1 if there is none
};

/// Finds holes half a pitch or more from the position that the others of their row give their column, in sheet order.
/// Columns are taken to be a constant step apart; rows may begin anywhere. Empty if more than a few holes were found,
/// because the map then numbers its columns in another way. The sheet must have no problems.
[[nodiscard]] std::vector<MisnamedHole> findMisnamedHoles(const Sheet& sheet);

}  // namespace tubeplan::tubesheets
