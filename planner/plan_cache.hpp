// Cache of the costly results of planning, so that a stopped plan can resume and a changed work list can reuse results
// that are still valid. Except for the orders, each entry is the result for one tube or one travel, independent of the
// rest of the work list.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "planner/motion/motion_planner.hpp"
#include "planner/order/visit_order.hpp"
#include "planner/reach/tube_reach.hpp"

namespace tubeplan::planner {

/// A tube (index in the sheet) with the index of a branch of its reach.
struct TubePosture {
  int tube, branch;
  auto operator<=>(const TubePosture&) const = default;
};

/// The two ends of a travel between the standoffs of two tubes. Two equal ends denote the approach to that tube.
using MotionEnds = std::pair<TubePosture, TubePosture>;

/// The proved smallest margin along a path segment, and the clearance of the tightest posture.
struct SegmentProof {
  /// Margin beyond the clearance that the scene requires [m].
  double margin = std::numeric_limits<double>::quiet_NaN();
  Clearance tightest;
};

struct PlanCache {
  std::map<int, TubeReach> reach;             ///< reach of each tube, keyed by tube index
  std::map<MotionEnds, MotionPlan> travels;   ///< travels, keyed by their ends with the smaller end first
  std::map<MotionEnds, SegmentProof> proofs;  ///< proofs of segments, keyed by their ends in the direction of travel
  /// The order found in each round of planning; its visits are indices into the reachable tubes of the current work
  /// list.
  std::vector<VisitOrder> orders;
  /// Tubes in the order of the last completed plan. The next search starts from this order if most tubes are the same.
  std::vector<int> visiting_order;
};

/// Numbers of results reused from the cache.
struct KeptWork {
  int reach = 0;    ///< number of tubes whose reach was reused
  int travels = 0;  ///< number of travels along the path that were reused
  int proofs = 0;   ///< number of segments whose proofs were reused, not counting retreats
};

}  // namespace tubeplan::planner
