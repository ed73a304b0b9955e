// Sets of postures whose border a relaxed route crosses too seldom. Internal to the lower bound.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "planner/order/neighbour_lists.hpp"
#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

/// For each edge between two postures, the mean number of times that it is used over several trees.
using EdgeUse = std::map<std::pair<int, int>, double>;

/// Returns up to `most` sets, each as one flag per posture: nonzero if the posture is in the set. Each set has all
/// postures of one visit and none of another, so that every route crosses the border of the set at least once; the used
/// edges cross it less than once. The sets are minimum cuts between visits (maximum flow through the used edges). A
/// posture without used edges is on the side of the nearest posture that has them.
[[nodiscard]] std::vector<std::vector<char>> findCrossedTooSeldom(const PostureTable& table,
                                                                  const std::vector<std::vector<Neighbour>>& neighbours,
                                                                  const EdgeUse& use, std::size_t most);

}  // namespace tubeplan::planner
