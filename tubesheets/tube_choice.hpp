// Ways to choose tubes of a sheet: how deep from the periphery, evenly spread, every k-th.
#pragma once

#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

/// For every tube of the sheet how deep it lies: 1 on the periphery, 2 when it comes to lie there once those are taken
/// away, and so on. A tube is on the periphery when it has fewer neighbours than a tube inside the lattice has; the row
/// along the divider lane and the edge of a stay cylinder or of a missing hole count as periphery too.
[[nodiscard]] std::vector<int> peelDepths(const Sheet& sheet);

/// `count` of the candidates (places in sheet.tubes) spread evenly: first the one nearest their middle, then always the
/// one farthest from those already chosen; ties go to the first in sheet order. Ascending. All of them when
/// there are no more than that.
[[nodiscard]] std::vector<int> chooseSpread(const Sheet& sheet, const std::vector<int>& candidates, int count);

/// The first candidate and every k-th after it.
[[nodiscard]] std::vector<int> chooseEvery(const std::vector<int>& candidates, int k);

}  // namespace tubeplan::tubesheets
