// Nearest-neighbour routes that are used as starting orders for the local search. Internal to the ordering.
#pragma once

#include <vector>

#include "planner/order/neighbour_lists.hpp"
#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

/// Returns several orders of all visits. Each order always continues with the nearest remaining visit. The first may
/// use any branches for each move. One order for each branch of the first visit goes to the nearest posture, so that
/// the arm stays in one branch as long as possible. Further orders use only one branch at each tube: the one in which a
/// narrow or wide neighbourhood is quickest to cross. The arm then changes its branch between regions.
[[nodiscard]] std::vector<std::vector<int>> startTours(const PostureTable& table,
                                                       const std::vector<std::vector<Neighbour>>& neighbours);

}  // namespace tubeplan::planner
