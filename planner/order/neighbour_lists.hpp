// For each node of a route, the other nodes nearest to it, sorted by the time of the quickest straight move between any
// of their branches. Internal to the ordering.
#pragma once

#include <vector>

#include "planner/order/posture_table.hpp"

namespace tubeplan::planner {

struct Neighbour {
  int node;
  double time;  ///< time of the quickest straight move between any branches of the two nodes, without extra time [s]
};

/// Returns up to `count` neighbours for each node, nearest first, with ties in order of node numbers. The lists are
/// exact; they are found by a sweep along the joint with the widest range of values.
[[nodiscard]] std::vector<std::vector<Neighbour>> nearestNeighbours(const PostureTable& table, int count);

}  // namespace tubeplan::planner
