// Detection of holes whose coordinates do not fit the lattice of their neighbours, for example because of a typing
// error in a map.
#pragma once

#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

struct HoleOffLattice {
  int tube = -1;        ///< index of the hole in Sheet::tubes
  double distance = 0;  ///< distance from the nearest lattice point [m]
  double x = 0, y = 0;  ///< position of the nearest lattice point [m]
};

/// Finds holes that are a tenth of a pitch or more off the lattice on which their neighbours agree, in sheet order;
/// manufacturing scatter is a hundredth of a pitch. Each hole is compared only with holes within a few pitches, so that
/// parts of a sheet may be shifted or separated by lanes. A hole with fewer than four agreeing neighbours is not
/// checked. The result is empty if the holes form no lattice. The sheet must have no problems.
[[nodiscard]] std::vector<HoleOffLattice> findHolesOffLattice(const Sheet& sheet);

}  // namespace tubeplan::tubesheets
