// Costly results of a plan, kept so that a stopped plan can resume and a changed list reuses what is still valid. Every
// entry answers a question of its own (one tube, one travel), independent of the rest of the list.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "planner/motion/motion_planner.hpp"
#include "planner/order/visit_order.hpp"
#include "planner/reach/tube_reach.hpp"

namespace tubeplan::planner {

/// A tube (index in the sheet) in one of the branches of its reach.
struct TubePosture {
  int tube, branch;
  auto operator<=>(const TubePosture&) const = default;
};

/// Ends of a travel between the standoffs of two tubes; if both tubes are the same, of the approach to it.
using MotionEnds = std::pair<TubePosture, TubePosture>;

/// Proved least clearance of a segment.
struct SegmentProof {
  double margin = std::numeric_limits<double>::quiet_NaN();  ///< beyond the clearance that the scene requires [m]
  Clearance tightest;
};

struct PlanCache {
  std::map<int, TubeReach> reach;             ///< reach of each tube
  std::map<MotionEnds, MotionPlan> travels;   ///< travels by their ends, with the smaller end first
  std::map<MotionEnds, SegmentProof> proofs;  ///< proofs of segments by their ends, in the direction of travel
  std::vector<VisitOrder> orders;             ///< order of each round, in terms of this list's reachable tubes
  /// Tubes in the order of the last completed plan. The next search starts from it if most tubes are the same.
  std::vector<int> visiting_order;
};

/// Numbers of results that were reused.
struct KeptWork {
  int reach = 0;    ///< tubes
  int travels = 0;  ///< travels of the path
  int proofs = 0;   ///< proofs of segments, without retreats
};

}  // namespace tubeplan::planner
