// Nearest-neighbour routes as starts of the search. Internal to the ordering.
#pragma once

#include <vector>

#include "planner/order/neighbour_lists.hpp"
#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

/// Returns orders of all visits. One uses the least time over the branches of two visits. One for each branch of its
/// first visit always takes the nearest posture, so that the arm keeps to one branch while it can. Some stay in the
/// branch in which a tube's neighbourhood, narrow or wide, is quickest to cross, so that the arm changes branch between
/// regions.
[[nodiscard]] std::vector<std::vector<int>> startTours(const PostureTable& table,
                                                       const std::vector<std::vector<Neighbour>>& neighbours);

}  // namespace tubeplan::planner
