// Sets of postures whose border a relaxed route crosses too seldom. Internal to the lower bound.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "planner/order/neighbour_lists.hpp"
#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

/// How much of each edge between two postures is used, on the average of trees.
using EdgeUse = std::map<std::pair<int, int>, double>;

/// Up to `most` sets, by posture, each with all postures of one visit and none of another. A route crosses the border
/// of each once at least; what is used crosses it less. Found as least cuts between visits (a flow through used edges);
/// a posture that nothing uses is on the side of the used one that is nearest to it.
[[nodiscard]] std::vector<std::vector<char>> findCrossedTooSeldom(const PostureTable& table,
                                                                  const std::vector<std::vector<Neighbour>>& neighbours,
                                                                  const EdgeUse& use, std::size_t most);

}  // namespace tubeplan::planner
