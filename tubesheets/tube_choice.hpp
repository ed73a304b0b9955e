// Ways to choose tubes of a sheet: by depth from the periphery, evenly spread, or every k-th.
#pragma once

#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

/// Returns the depth of each tube of the sheet: 1 for tubes on the periphery, 2 for tubes that are on the periphery
/// once these are removed, and so on. A tube is on the periphery if it has fewer neighbours than a tube inside the
/// lattice. The row along the divider lane and the edge of a stay cylinder or of a missing hole are periphery, too.
[[nodiscard]] std::vector<int> peelDepths(const Sheet& sheet);

/// Chooses `count` of the candidates (indices in Sheet::tubes), evenly spread: first the candidate nearest their mean
/// position, then repeatedly the candidate farthest from all tubes already chosen. Ties go to the first candidate in
/// sheet order. The result is ascending, and has all candidates if there are no more than `count`.
[[nodiscard]] std::vector<int> chooseSpread(const Sheet& sheet, const std::vector<int>& candidates, int count);

/// Returns the first candidate and every k-th candidate after it.
[[nodiscard]] std::vector<int> chooseEvery(const std::vector<int>& candidates, int k);

}  // namespace tubeplan::tubesheets
