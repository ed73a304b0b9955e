// Holes of a map whose names do not fit where they lie: the slip that ends in the wrong tube.
#pragma once

#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

struct MisnamedHole {
  int tube = -1;        ///< its place in `tubes`
  double x = 0, y = 0;  ///< where the other holes of its row put its column [m]
  int there = -1;       ///< the hole that lies there; -1 where none does
};

/// Holes half a pitch or more from where the others of their row put their column, in sheet order. Columns are taken to
/// be a constant step apart, rows to begin anywhere. Empty where more than a few would be: then the map counts
/// otherwise. The sheet must have no problems.
[[nodiscard]] std::vector<MisnamedHole> findMisnamedHoles(const Sheet& sheet);

}  // namespace tubeplan::tubesheets
