// What a plan found out at a cost, kept so that a plan that was stopped goes on and a changed list keeps what still
// holds. Every entry is the answer to a question of its own (one tube, one travel), whatever else the list asks for.
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

/// A travel between the standoffs of two tubes; the approach to a tube, where both are the same.
using MotionEnds = std::pair<TubePosture, TubePosture>;

/// A segment's least clearance, proved.
struct SegmentProof {
  double margin = std::numeric_limits<double>::quiet_NaN();  ///< m, beyond the clearance that the scene asks for
  Clearance tightest;
};

struct PlanCache {
  std::map<int, TubeReach> reach;             ///< by tube
  std::map<MotionEnds, MotionPlan> travels;   ///< the lesser end first
  std::map<MotionEnds, SegmentProof> proofs;  ///< as travelled
  std::vector<VisitOrder> orders;             ///< round after round, in terms of this list's reachable tubes
  /// Tubes in the order of the plan that was completed last. The next one begins from it where most tubes are the same.
  std::vector<int> visiting_order;
};

/// How much of a plan was there before.
struct KeptWork {
  int reach = 0;    ///< tubes
  int travels = 0;  ///< of the path
  int proofs = 0;   ///< of segments, retreats left out
};

}  // namespace tubeplan::planner
