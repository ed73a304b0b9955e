// The order of visits found with the true times of moves, including detours around obstacles. Internal to the planning
// of visits.
#pragma once

#include <string>
#include <vector>

#include "planner/travel_network.hpp"

namespace tubeplan::planner {

/// Tubes that can be visited, and the branches of each tube that may be used.
struct VisitChoice {
  std::vector<TubeReach> reach;            ///< reach of each tube; only reachable tubes
  std::vector<std::vector<int>> branches;  ///< for each tube, the indices of its branches that may be used

  [[nodiscard]] std::vector<int> tubes() const;
};

/// Returns the standoff postures of all branches of each tube's reach, tube by tube, followed by the start posture if
/// there is one.
[[nodiscard]] std::vector<Eigen::VectorXd> standoffsOf(const VisitChoice& choice, const VisitConditions& conditions);

[[nodiscard]] VisitChoice allBranches(std::vector<TubeReach> reach);

/// Returns the ordering problem for the chosen branches: branch b of a visit is the b-th branch that may be used.
[[nodiscard]] Route routeOf(const VisitChoice& choice, const JointSpeeds& speeds, const VisitConditions& conditions);

/// Keeps the branches in one part of the free space, as connected by the roadmap: the part of the start posture or,
/// without one, the part with the most tubes. Branches that the roadmap connects to nothing are kept, because a search
/// may still find a path. Returns the tubes left out; `between` is the obstacle met on the path to one of these tubes.
[[nodiscard]] std::vector<UnreachableTube> keepOnePart(VisitChoice& choice, const Roadmap& roadmap,
                                                       const VisitConditions& conditions, const Clearance& between);

struct RealOrder {
  std::vector<Stop> stops;  ///< stops with start and end posture included; empty if no order was found
  std::string reason;       ///< reason if no order was found
  /// Proved lower bound of the travel time, for straight moves [s].
  double lower_bound = std::numeric_limits<double>::quiet_NaN();
  /// True if a move of the order leads between parts of the free space that are not connected; the search may then be
  /// abandoned.
  bool is_parted = false;
  Clearance between;  ///< obstacle of the first move between disconnected parts
};

/// Finds an order with straight times, plans its moves, sets their true times, and repeats until no move's time
/// changes. Returns the quickest order of all rounds. `rounds_done` counts the rounds, each of which has its order in
/// the cache.
[[nodiscard]] RealOrder orderWithRealMoves(const PlanContext& context, const VisitChoice& choice,
                                           TravelNetwork& network, bool gives_up_if_parted, std::size_t& rounds_done);

/// Returns the longest run of stops with a travel from each stop to the next, with the other runs that can be connected
/// to it. Tubes that cannot be connected are added to `left_out`.
[[nodiscard]] std::vector<Stop> joinRuns(const std::vector<Stop>& stops, const VisitChoice& choice,
                                         TravelNetwork& network, const VisitConditions& conditions,
                                         std::vector<UnreachableTube>& left_out);

}  // namespace tubeplan::planner
