// Holes of a map that do not lie where the holes about them put them: a slip in one pair of coordinates.
#pragma once

#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

struct HoleOffLattice {
  int tube = -1;        ///< its place in `tubes`
  double distance = 0;  ///< m, from the nearest place of the lattice ...
  double x = 0, y = 0;  ///< ... which is here [m]
};

/// Holes a tenth of a pitch or more off the lattice that their neighbours agree on, in sheet order: manufacture
/// scatters by a hundredth. Each hole is judged by those within a few pitches alone, so that parts of a sheet may be
/// shifted or parted by lanes; one with fewer than four that agree is not judged. Empty for holes that make no lattice.
/// The sheet must have no problems.
[[nodiscard]] std::vector<HoleOffLattice> findHolesOffLattice(const Sheet& sheet);

}  // namespace tubeplan::tubesheets
