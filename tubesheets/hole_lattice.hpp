// A hole whose coordinates do not fit the lattice of its neighbours, as after a typing error in a map.
#pragma once

#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

struct HoleOffLattice {
  int tube = -1;        ///< index in Sheet::tubes
  double distance = 0;  ///< distance from the nearest lattice point [m]
  double x = 0, y = 0;  ///< the nearest lattice point [m]
};

/// Finds holes a tenth of a pitch or more off the lattice that their neighbours agree on, in sheet order; manufacture
/// scatters by a hundredth. Each hole is judged by those within a few pitches alone, so that parts of a sheet may be
/// shifted or separated by lanes. A hole with fewer than four agreeing neighbours is not judged. Empty for holes that
/// form no lattice. The sheet must have no problems.
[[nodiscard]] std::vector<HoleOffLattice> findHolesOffLattice(const Sheet& sheet);

}  // namespace tubeplan::tubesheets
