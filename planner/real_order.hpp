// The order of visits by the true times of its moves, with obstacles. Internal to the planning of visits.
#pragma once

#include <string>
#include <vector>

#include "planner/travel_network.hpp"

namespace tubeplan::planner {

/// Tubes that can be visited, and their branches that may be used.
struct VisitChoice {
  std::vector<TubeReach> reach;            ///< reachable ones alone
  std::vector<std::vector<int>> branches;  ///< one list for each tube

  [[nodiscard]] std::vector<int> tubes() const;
};

/// Returns the standoffs of the visits, tube by tube in every branch of its reach; then the start posture, if there is
/// one.
[[nodiscard]] std::vector<Eigen::VectorXd> standoffsOf(const VisitChoice& choice, const VisitConditions& conditions);

[[nodiscard]] VisitChoice allBranches(std::vector<TubeReach> reach);

/// Returns the ordering problem of that choice: branch b of a visit is the b-th that may be used.
[[nodiscard]] Route routeOf(const VisitChoice& choice, const JointSpeeds& speeds, const VisitConditions& conditions);

/// Keeps the branches in one part of the free space, by the roadmap: the part of the start posture, else the one with
/// the most tubes. Branches that are joined to nothing stay, because a search may still find a path. Returns the tubes
/// left out; `between` is the obstacle met on the path to one of them.
[[nodiscard]] std::vector<UnreachableTube> keepOnePart(VisitChoice& choice, const Roadmap& roadmap,
                                                       const VisitConditions& conditions, const Clearance& between);

struct RealOrder {
  std::vector<Stop> stops;  ///< start and end posture included; empty: none was found
  std::string reason;       ///< reason if there is none
  /// Proved lower bound of the time, for straight moves [s].
  double lower_bound = std::numeric_limits<double>::quiet_NaN();
  bool is_parted = false;  ///< true: abandoned, because a move leads between parts of the free space that nothing joins
  Clearance between;       ///< obstacle of that move
};

/// Finds an order by straight times, plans its moves, sets their true times, and repeats until no move changes its
/// time. Returns the quickest of all rounds. `rounds_done` counts the orders that the cache keeps.
[[nodiscard]] RealOrder orderWithRealMoves(const PlanContext& context, const VisitChoice& choice,
                                           TravelNetwork& network, bool gives_up_if_parted, std::size_t& rounds_done);

/// Returns the longest stretch of stops, if some have no travel between them, and what can be joined to it. The other
/// tubes are added to `left_out`.
[[nodiscard]] std::vector<Stop> joinRuns(const std::vector<Stop>& stops, const VisitChoice& choice,
                                         TravelNetwork& network, const VisitConditions& conditions,
                                         std::vector<UnreachableTube>& left_out);

}  // namespace tubeplan::planner
