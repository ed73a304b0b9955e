// Cache of the costly results of planning, so that a stopped plan can resume and a changed work list can reuse results
// that are still valid. Except for the orders, each entry is the result for one tube or one travel, independent of the
// rest of the work list.
#pragma once

#include <map>
#include <optional>
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

/// A proved lower bound of the travel time through the tubes of a completed plan.
struct KnownBound {
  double lower_bound = std::numeric_limits<double>::quiet_NaN();  ///< lower bound [s]; NaN if unknown
  std::optional<Eigen::VectorXd> start, end;  ///< end postures for which the bound is valid; any if std::nullopt
};

struct PlanCache {
  std::map<int, TubeReach> reach;             ///< reach of each tube, keyed by tube index
  std::map<MotionEnds, MotionPlan> travels;   ///< travels, keyed by their ends with the smaller end first
  std::map<MotionEnds, SegmentProof> proofs;  ///< proofs of segments, keyed by their ends in the direction of travel
  /// The order found in each round of planning; its visits are indices into the reachable tubes of the current work
  /// list.
  std::vector<VisitOrder> orders;
  /// Tubes in the order of the last completed plan. The next search starts from this order if few tubes are new.
  std::vector<int> visiting_order;
  std::vector<int> visiting_branches;  ///< branch of each tube in `visiting_order`; empty if they are not known
  KnownBound bound;                    ///< bound for the tubes in `visiting_order` with all their branches in `reach`
};

/// Numbers of results reused from the cache.
struct KeptWork {
  int reach = 0;       ///< number of tubes whose reach was reused
  int travels = 0;     ///< number of travels along the path that were reused
  int proofs = 0;      ///< number of segments whose proofs were reused, not counting retreats
  bool order = false;  ///< true if the search began with the order of an earlier plan
  bool bound = false;  ///< true if the lower bound follows from that of an earlier plan
};

}  // namespace tubeplan::planner
