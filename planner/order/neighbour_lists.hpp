// The nearest other nodes of each node of a route, by the least straight time over their branches. Internal to the
// ordering.
#pragma once

#include <vector>

#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

struct Neighbour {
  int node;
  double time;  ///< straight, least over the branches, without extra time [s]
};

/// Returns up to `count` neighbours for each node, nearest first; ties by number. Exact, by a sweep along the joint
/// with the widest spread.
[[nodiscard]] std::vector<std::vector<Neighbour>> nearestNeighbours(const PostureTable& table, int count);

}  // namespace tubeplan::planner
