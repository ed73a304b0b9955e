// Nearest-neighbour routes to begin the search from. Internal to the ordering.
#pragma once

#include <vector>

#include "planner/order/neighbour_lists.hpp"
#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

/// Orders of all visits: one by the least time over the branches of two visits; one for each branch of its first visit,
/// which goes on to the nearest posture from there, so that the arm keeps to one branch while it can; and some that
/// stay in the branch in which a tube's neighbourhood is quickest to cross, seen narrowly or widely, so that the arm
/// changes branch between regions.
[[nodiscard]] std::vector<std::vector<int>> startTours(const PostureTable& table,
                                                       const std::vector<std::vector<Neighbour>>& neighbours);

}  // namespace tubeplan::planner
