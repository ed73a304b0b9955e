// The order of visits by what its moves really take, obstacles and all. Internal to the planning of visits.
#pragma once

#include <string>
#include <vector>

#include "planner/travel_network.hpp"

namespace tubeplan::planner {

/// Tubes that can be visited, and which of their branches may be used.
struct VisitChoice {
  std::vector<TubeReach> reach;            ///< reachable ones alone
  std::vector<std::vector<int>> branches;  ///< one list for each

  [[nodiscard]] std::vector<int> tubes() const;
};

/// Where the visits may be approached from, tube by tube in every branch of its reach; then the start posture, where
/// there is one.
[[nodiscard]] std::vector<Eigen::VectorXd> standoffsOf(const VisitChoice& choice, const VisitConditions& conditions);

[[nodiscard]] VisitChoice allBranches(std::vector<TubeReach> reach);

/// The ordering problem of that choice: branch b of a visit is the b-th that may be used.
[[nodiscard]] Route routeOf(const VisitChoice& choice, const JointSpeeds& speeds, const VisitConditions& conditions);

/// Keeps what lies in one part of the free space, as the roadmap has it: that of the start posture, else that with the
/// most tubes. What is joined to nothing stays, for a search may still find a way. Gives the tubes left out; `between`
/// is what was met on the way to one of them.
[[nodiscard]] std::vector<UnreachableTube> keepOnePart(VisitChoice& choice, const Roadmap& roadmap,
                                                       const VisitConditions& conditions, const Clearance& between);

struct RealOrder {
  std::vector<Stop> stops;  ///< start and end posture included; empty: none was found
  std::string reason;       ///< why not
  double lower_bound = std::numeric_limits<double>::quiet_NaN();  ///< s, proved, of straight moves
  bool is_parted = false;  ///< given up: a move was met between parts of the free space that nothing joins ...
  Clearance between;       ///< ... and this is in the way of it
};

/// Orders on the metric, plans the chosen moves, puts in what they really cost, and orders again until no move
/// surprises; of all rounds the quickest. `rounds_done` counts the orders that the memory keeps.
[[nodiscard]] RealOrder orderWithRealMoves(const PlanContext& context, const VisitChoice& choice,
                                           TravelNetwork& network, bool gives_up_if_parted, std::size_t& rounds_done);

/// Where no travel was found between two stops: the longest stretch and what can be joined to it. The other tubes are
/// added to `left_out`.
[[nodiscard]] std::vector<Stop> joinRuns(const std::vector<Stop>& stops, const VisitChoice& choice,
                                         TravelNetwork& network, const VisitConditions& conditions,
                                         std::vector<UnreachableTube>& left_out);

}  // namespace tubeplan::planner
