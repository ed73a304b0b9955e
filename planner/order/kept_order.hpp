// The order of an earlier plan, adapted to a work list that changed by a few tubes. Internal to the planning of visits.
#pragma once

#include <vector>

#include "planner/order/route.hpp"

namespace tubeplan::planner {

/// Returns the visits of the route in the order of `tubes_before`, with new tubes inserted where they add the least
/// time. `tubes` has the tube index of each visit. Empty if more than the fraction `most_changed` of all visits was
/// added or removed. A new search is then worthwhile.
[[nodiscard]] std::vector<int> keptOrder(const Route& route, const std::vector<int>& tubes,
                                         const std::vector<int>& tubes_before, double most_changed = 0.1);

}  // namespace tubeplan::planner
