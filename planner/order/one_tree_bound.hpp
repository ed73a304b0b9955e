// A proved lower bound on the travel time of any route.
//
// A route is a path, so it is a spanning tree in which each visit has two edge ends (a free end of the route is also an
// edge end), both at the same branch. The bound is the cost of the cheapest spanning tree with Lagrangian prices for
// these conditions (see priced_tree.hpp), which extends Held and Karp (1970, 1971) to several branches. Prices are
// found on a sparse graph; the bound itself is always computed on the complete graph. With prices alone, a relaxed
// route may take half of one family of postures and half of another. Cuts that every route must cross
// (posture_cuts.hpp) prevent that.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "planner/order/route.hpp"

namespace tubeplan::planner {

struct OneTreeOptions {
  int iterations = 1500;  ///< total number of subgradient steps on the sparse graph
  int rounds = 4;       ///< number of trees on the complete graph; the edges of each tree are added to the sparse graph
  int neighbours = 10;  ///< number of nearest neighbours of each visit in the sparse graph
  int complete_up_to = 30;  ///< with at most this many visits, all steps use the complete graph
  int cuts_up_to = 100;     ///< with at most this many visits, cuts are added if visits have several branches
  /// Largest number of refinement rounds that add cuts, run after the ordinary rounds. They stop early once the
  /// improvement is small.
  int cut_rounds = 12;
  /// Travel time of a known route, which controls the step size [s].
  double known_time = std::numeric_limits<double>::quiet_NaN();
  /// Called at every step; returns true to stop early. The bound found so far is then returned.
  std::function<bool()> stop;
};

enum class OneTreeStatus { kNotRun, kSolved, kBadInput };

struct OneTreeBound {
  OneTreeStatus status = OneTreeStatus::kNotRun;
  std::string reason;
  double lower_bound = std::numeric_limits<double>::quiet_NaN();  ///< lower bound of the travel time [s]
  int iterations = 0;
};

/// Computes the bound. It holds for every route of straight moves, with or without intermediate stops, because straight
/// times obey the triangle inequality. Extra times are ignored, because they are not proved.
[[nodiscard]] OneTreeBound oneTreeBound(const Route& route, const OneTreeOptions& options = {});

}  // namespace tubeplan::planner
