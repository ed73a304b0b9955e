// The order of an earlier plan, adapted to a work list that changed by a few tubes. Internal to the planning of visits.
#pragma once

#include <vector>

#include "planner/order/route.hpp"

namespace tubeplan::planner {

/// Returns the visits of the route in the order of `tubes_before`, with new tubes inserted where they add the least
/// time. `tubes` has the tube index of each visit. Empty if none of them is in `tubes_before`, or if more tubes were
/// added than the fraction `most_added` of all visits: a new search is then worthwhile.
[[nodiscard]] std::vector<int> keptOrder(const Route& route, const std::vector<int>& tubes,
                                         const std::vector<int>& tubes_before, double most_added = 0.1);

/// Returns the number of neighbouring pairs in an order of visits that were not neighbours in `tubes_before`.
[[nodiscard]] int countNewNeighbours(const std::vector<int>& order, const std::vector<int>& tubes,
                                     const std::vector<int>& tubes_before);

}  // namespace tubeplan::planner
