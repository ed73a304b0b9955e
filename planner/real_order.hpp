// Search for the quickest order of visits with the true times of moves, which include detours around obstacles.
// Internal to the planning of visits.
#pragma once

#include <string>
#include <vector>

#include "planner/travel_network.hpp"

namespace tubeplan::planner {

/// Tubes that can be visited, and the branches of each tube that may be used.
struct VisitChoice {
  std::vector<TubeReach> reach;            ///< reach of each tube; all of these tubes are reachable
  std::vector<std::vector<int>> branches;  ///< for each tube, the indices of its branches that may be used

  [[nodiscard]] std::vector<int> tubes() const;
};

/// Returns the standoff postures of all branches of each tube's reach, tube by tube, followed by the start posture if
/// there is one.
[[nodiscard]] std::vector<Eigen::VectorXd> standoffsOf(const VisitChoice& choice, const VisitConditions& conditions);

[[nodiscard]] VisitChoice allBranches(std::vector<TubeReach> reach);

/// Returns the ordering problem in which branch b of a visit is the b-th of the branches that may be used at its tube.
[[nodiscard]] Route routeOf(const VisitChoice& choice, const JointSpeeds& speeds, const VisitConditions& conditions);

/// Reduces `choice` to branches in one part of the free space that the roadmap connects: the part of the start posture
/// or, without one, the part with the most tubes. Branches that the roadmap connects to nothing are kept, because a
/// search may still find a path. Returns the tubes that are left without a branch. The stated reason is `between`, the
/// obstacle on the way to one of them.
[[nodiscard]] std::vector<UnreachableTube> keepOnePart(VisitChoice& choice, const Roadmap& roadmap,
                                                       const VisitConditions& conditions, const Clearance& between);

struct RealOrder {
  std::vector<Stop> stops;  ///< stops with start and end posture included; empty if no order was found
  std::string reason;       ///< reason why no order was found; empty if there is an order
  /// Proved lower bound of the travel time [s]; it assumes that all moves are straight.
  double lower_bound = std::numeric_limits<double>::quiet_NaN();
  bool has_kept_order = false;  ///< true if the search began with the order of an earlier plan
  bool has_kept_bound = false;  ///< true if the bound follows from that of an earlier plan
  /// True if a move of the order leads between parts of the free space that are not connected; the search may then be
  /// abandoned.
  bool is_parted = false;
  Clearance between;  ///< obstacle in the way of the first move between disconnected parts
};

/// Finds an order with straight times, plans its moves, sets their true times, and repeats until no move's time
/// changes. Returns the quickest order of all rounds. `rounds_done` is increased by the number of rounds whose orders
/// are in the cache.
[[nodiscard]] RealOrder orderWithRealMoves(const PlanContext& context, const VisitChoice& choice,
                                           TravelNetwork& network, bool gives_up_if_parted, std::size_t& rounds_done);

/// Splits the stops into runs in which every stop has a free travel to the next. Returns the longest run, joined with
/// the other runs that can be connected to it; tubes of all other runs are added to `left_out`.
[[nodiscard]] std::vector<Stop> joinRuns(const std::vector<Stop>& stops, const VisitChoice& choice,
                                         TravelNetwork& network, const VisitConditions& conditions,
                                         std::vector<UnreachableTube>& left_out);

}  // namespace tubeplan::planner
