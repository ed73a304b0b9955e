// A proved lower bound on the travel time of any route.
//
// A route is a path, so it is a spanning tree whose visits have two edges each (free ends count as one), both in one
// branch. The bound is the smallest spanning tree after Lagrangian prices for these conditions (see priced_tree.hpp),
// which extends Held and Karp (1970, 1971) to several branches. Prices are found on a sparse graph; the bound itself is
// always taken on the complete one. Prices alone let a tree be half in one family of postures and half in another;
// borders that every route must cross (posture_cuts.hpp) stop that.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "planner/order/route.hpp"

namespace tubeplan::planner {

struct OneTreeOptions {
  int iterations = 1500;    ///< number of subgradient steps on the sparse graph, in all
  int rounds = 4;           ///< number of trees on the complete graph; each adds its edges to the sparse one
  int neighbours = 10;      ///< neighbours of each visit in the sparse graph
  int complete_up_to = 30;  ///< number of visits up to which the complete graph is used throughout
  int cuts_up_to = 100;     ///< number of visits up to which problems with a few branches each add border cuts
  int cut_rounds = 12;      ///< rounds of cuts after the other rounds, while they gain enough
  /// Time of a known route, which controls the step size [s].
  double known_time = std::numeric_limits<double>::quiet_NaN();
  std::function<bool()> stop;  ///< called at every step; the bound so far is valid if it stops
};

enum class OneTreeStatus { kNotRun, kSolved, kBadInput };

struct OneTreeBound {
  OneTreeStatus status = OneTreeStatus::kNotRun;
  std::string reason;
  double lower_bound = std::numeric_limits<double>::quiet_NaN();  ///< [s]
  int iterations = 0;
};

/// Computes the bound. It holds for every route of straight moves, with or without further stops, because straight
/// times obey the triangle inequality. Extra times are ignored, because they are not proved.
[[nodiscard]] OneTreeBound oneTreeBound(const Route& route, const OneTreeOptions& options = {});

}  // namespace tubeplan::planner
