// The nearest other nodes of each node of a route, sorted by the time of the shortest straight move over the branches
// of both nodes. Internal to the ordering.
#pragma once

#include <vector>

#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

struct Neighbour {
  int node;
  double time;  ///< time of the shortest straight move over the branches of both nodes, without extra time [s]
};

/// Returns up to `count` neighbours for each node, nearest first, ties in the order of node numbers. The lists are
/// exact; they are found by a sweep along the joint with the widest range of values.
[[nodiscard]] std::vector<std::vector<Neighbour>> nearestNeighbours(const PostureTable& table, int count);

}  // namespace tubeplan::planner
