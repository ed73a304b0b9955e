// Sets of postures whose border a relaxed route crosses too seldom. Internal to the lower bound.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "planner/order/neighbour_lists.hpp"
#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

/// Use of each edge between two postures, averaged over trees.
using EdgeUse = std::map<std::pair<int, int>, double>;

/// Returns up to `most` sets, by posture, each with all postures of one visit and none of another. A route crosses the
/// border of each at least once; the used edges cross it less. The sets are minimum cuts between visits (a flow through
/// used edges). An unused posture is on the side of the nearest used one.
[[nodiscard]] std::vector<std::vector<char>> findCrossedTooSeldom(const PostureTable& table,
                                                                  const std::vector<std::vector<Neighbour>>& neighbours,
                                                                  const EdgeUse& use, std::size_t most);

}  // namespace tubeplan::planner
