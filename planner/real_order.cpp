#include "planner/real_order.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "planner/few_tubes.hpp"
#include "planner/order/exact_order.hpp"
#include "planner/order/kept_order.hpp"
#include "planner/order/posture_table.hpp"
#include "planner/order/zoned_order.hpp"
#include "planner/remaining_bound.hpp"

namespace tubeplan::planner {

namespace {

// Largest relative gap at which the bound of an earlier plan is reused: a tighter bound takes longer
// to find than the order.
constexpr double kGoodGap = 0.03;
constexpr int kKicksPerNewNeighbour = 100;  // kicks of an earlier plan's order, for each place where it was changed
constexpr int kLaterKicksShare = 10;  // divisor of the number of kicks in later rounds, which start from a good order

/// Returns the index within the tube's reach of the `branch`-th branch that may be used; 0 for the start and end
/// postures.
int branchOf(const VisitChoice& choice, int visit, int branch) {
  return visit < 0 ? 0 : choice.branches[static_cast<std::size_t>(visit)][static_cast<std::size_t>(branch)];
}

/// Returns the order as stops, including the start and end postures if there are any.
std::vector<Stop> stopsOf(const VisitOrder& order, const VisitChoice& choice, const VisitConditions& conditions) {
  std::vector<Stop> stops;
  if (conditions.start) stops.push_back({kStartPosture, 0});
  for (std::size_t k = 0; k < order.order.size(); ++k)
    stops.push_back({order.order[k], branchOf(choice, order.order[k], order.branches[k])});
  if (conditions.end) stops.push_back({kEndPosture, 0});
  return stops;
}

/// Result of planning all moves of an order; `learnt` is true if a move has extra time that was not known before.
struct Priced {
  bool learnt = false, is_parted = false;
  Clearance between;  ///< obstacle in the way of the first move between disconnected parts
  double time = 0;    ///< total time [s], with kForbiddenTime for each move without a path
};

/// Plans the moves of an order and records their extra times in `penalties`.
Priced priceOrder(const PlanContext& context, const std::vector<Stop>& stops, TravelNetwork& network,
                  EdgePenalties& penalties) {
  Priced priced;
  for (std::size_t k = 0; k + 1 < stops.size() && !context.isStopped(); ++k) {
    const Stop a = stops[k], b = stops[k + 1];
    context.showProgress("travel", k + 1, stops.size() - 1);
    const MotionPlan& travel = network.between(a, b);
    const double time = network.timeOf(travel);
    context.keepCache();
    if (travel.is_disconnected && !priced.is_parted) priced.between = travel.tightest;
    priced.is_parted |= travel.is_disconnected;
    priced.time += std::min(time, kForbiddenTime);
    const double extra = time - moveDuration(network.standoff(a), network.standoff(b), context.speeds);
    if (extra <= 1e-9 || penalties(a.visit, a.branch, b.visit, b.branch) > 0) continue;
    penalties.set(a.visit, a.branch, b.visit, b.branch, extra);
    priced.learnt = true;
  }
  return priced;
}

/// Adds extra times to a route; `penalties` and `choice` must outlive the route.
void addExtraTimes(const EdgePenalties& penalties, const VisitChoice& choice, Route& route) {
  route.extra_time = [&](int a, int branch_a, int b, int branch_b) {
    return penalties(a, branchOf(choice, a, branch_a), b, branchOf(choice, b, branch_b));
  };
  route.with_extra.clear();
  for (int visit = 0; visit < static_cast<int>(route.visits.size()); ++visit)
    route.with_extra.push_back(penalties.touches(visit));
}

/// Returns the order of one round, from the cache if it is there. If a search from the order of an earlier work list
/// cannot avoid a forbidden move, the search is repeated without this order.
VisitOrder orderOfRound(const PlanContext& context, const Route& route, const std::vector<int>& zones,
                        std::size_t round, VisitOrderOptions& ordering) {
  auto& known = context.cache.orders;
  if (round < known.size()) return known[round];
  context.showProgress("order", 0, 0);
  VisitOrder order = orderByZones(route, zones, ordering);
  if (order.status == VisitOrderStatus::kForbiddenMove && !ordering.start.empty()) {
    ordering.start.clear();
    order = orderByZones(route, zones, ordering);
  }
  if (context.isStopped()) return order;
  known.push_back(order);
  context.keepCache();
  return order;
}

/// Takes the order of the visits and its lower bound from an earlier plan.
void keepFromBefore(const PlanContext& context, const VisitChoice& choice, const Route& route,
                    VisitOrderOptions& ordering) {
  const std::vector<int>& before = context.cache.visiting_order;
  const std::vector<int> tubes = choice.tubes();
  ordering.known_bound = remainingBound(context, choice);
  ordering.good_gap = kGoodGap;
  ordering.start = keptOrder(route, tubes, before);
  ordering.start_kicks = kKicksPerNewNeighbour * countNewNeighbours(ordering.start, tubes, before);
}

std::string inTheWay(const MotionPlan& plan) {
  return plan.reason.empty() ? "no path from the tube before it" : "no path from the tube before it: " + plan.reason;
}

bool isFree(TravelNetwork& network, Stop a, Stop b) { return network.between(a, b).status == MotionPlanStatus::kFree; }

/// Splits the stops into runs in which every stop has a free travel to the next.
std::vector<std::vector<Stop>> travelledRuns(const std::vector<Stop>& stops, TravelNetwork& network) {
  std::vector<std::vector<Stop>> runs;
  for (const Stop& stop : stops) {
    if (runs.empty() || !isFree(network, runs.back().back(), stop)) runs.emplace_back();
    runs.back().push_back(stop);
  }
  return runs;
}

void leaveOut(const std::vector<Stop>& run, const MotionPlan& travel, const VisitChoice& choice,
              std::vector<UnreachableTube>& left_out) {
  for (const Stop& stop : run)
    if (stop.visit >= 0)
      left_out.push_back({choice.reach[static_cast<std::size_t>(stop.visit)].tube, inTheWay(travel), travel.tightest});
}

/// Keeps the longest run of stops and, before and after it, the runs that can be connected without a change of order.
/// All other tubes are reported as unreachable.
std::vector<Stop> joinInOrder(const std::vector<Stop>& stops, const VisitChoice& choice, TravelNetwork& network,
                              std::vector<UnreachableTube>& left_out) {
  const auto runs = travelledRuns(stops, network);
  const auto longest =
      std::max_element(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  std::vector<Stop> kept = *longest;
  for (auto run = longest + 1; run != runs.end(); ++run) {
    if (isFree(network, kept.back(), run->front()))
      kept.insert(kept.end(), run->begin(), run->end());
    else
      leaveOut(*run, network.between(kept.back(), run->front()), choice, left_out);
  }
  for (auto run = std::make_reverse_iterator(longest); run != runs.rend(); ++run) {
    if (isFree(network, run->back(), kept.front()))
      kept.insert(kept.begin(), run->begin(), run->end());
    else
      leaveOut(*run, network.between(run->back(), kept.front()), choice, left_out);
  }
  return kept;
}

/// Keeps the longest run of stops and the runs that can be connected to one of its ends; other tubes are reported as
/// unreachable.
std::vector<Stop> joinAnywhere(const std::vector<Stop>& stops, const VisitChoice& choice, TravelNetwork& network,
                               std::vector<UnreachableTube>& left_out) {
  auto runs = travelledRuns(stops, network);
  std::stable_sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  std::vector<Stop> kept = runs.front();
  for (std::size_t k = 1; k < runs.size(); ++k) {
    const auto& run = runs[k];
    if (isFree(network, kept.back(), run.front())) {
      kept.insert(kept.end(), run.begin(), run.end());
    } else if (isFree(network, run.back(), kept.front())) {
      kept.insert(kept.begin(), run.begin(), run.end());
    } else {
      leaveOut(run, network.between(kept.back(), run.front()), choice, left_out);
    }
  }
  return kept;
}

std::string disconnectedReason(const Clearance& between, bool has_start) {
  std::string reason = std::string("no path to it was found: the search did not connect it to ") +
                       (has_start ? "the start posture" : "the visited tubes") + " (another --seed may)";
  if (!between.body.empty())
    reason += "; on the straight motion between them, " + between.body + " comes too near " + between.other;
  return reason;
}

/// Returns the index of the part of the free space that contains branches of the most tubes; -1 if there is none.
int largestPart(const std::vector<std::vector<int>>& parts) {
  std::map<int, int> tubes;
  for (const auto& of_visit : parts) {
    std::vector<int> once = of_visit;
    std::ranges::sort(once);
    once.erase(std::ranges::unique(once).begin(), once.end());
    for (const int part : once) tubes[part] += part >= 0;
  }
  const auto most = std::ranges::max_element(tubes, [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == tubes.end() ? -1 : most->first;
}

}  // namespace

std::vector<int> VisitChoice::tubes() const {
  std::vector<int> tubes;
  for (const auto& tube : reach) tubes.push_back(tube.tube);
  return tubes;
}

std::vector<Eigen::VectorXd> standoffsOf(const VisitChoice& choice, const VisitConditions& conditions) {
  std::vector<Eigen::VectorXd> postures;
  for (const auto& tube : choice.reach)
    for (const auto& branch : tube.branches) postures.push_back(branch.approach.front());
  if (conditions.start) postures.push_back(*conditions.start);
  return postures;
}

VisitChoice allBranches(std::vector<TubeReach> reach) {
  VisitChoice choice{std::move(reach), {}};
  for (const auto& tube : choice.reach) {
    choice.branches.emplace_back();
    for (std::size_t b = 0; b < tube.branches.size(); ++b) choice.branches.back().push_back(static_cast<int>(b));
  }
  return choice;
}

Route routeOf(const VisitChoice& choice, const JointSpeeds& speeds, const VisitConditions& conditions) {
  Route route;
  route.speeds = speeds;
  route.start = conditions.start;
  route.end = conditions.end;
  for (std::size_t k = 0; k < choice.reach.size(); ++k) {
    Visit visit;
    for (const int branch : choice.branches[k])
      visit.branches.push_back(choice.reach[k].branches[static_cast<std::size_t>(branch)].approach.front());
    route.visits.push_back(std::move(visit));
  }
  return route;
}

std::vector<UnreachableTube> keepOnePart(VisitChoice& choice, const Roadmap& roadmap, const VisitConditions& conditions,
                                         const Clearance& between) {
  const std::vector<int> flat = roadmap.partsOf(standoffsOf(choice, conditions));
  std::vector<std::vector<int>> parts;
  std::size_t at = 0;
  for (const auto& tube : choice.reach) {
    parts.emplace_back(flat.begin() + static_cast<std::ptrdiff_t>(at),
                       flat.begin() + static_cast<std::ptrdiff_t>(at + tube.branches.size()));
    at += tube.branches.size();
  }
  const int kept = conditions.start && flat.back() >= 0 ? flat.back() : largestPart(parts);
  std::vector<UnreachableTube> left_out;
  VisitChoice in_part;
  for (std::size_t k = 0; k < choice.reach.size(); ++k) {
    std::vector<int> branches;
    for (const int branch : choice.branches[k])
      if (const int part = parts[k][static_cast<std::size_t>(branch)]; part == kept || part < 0)
        branches.push_back(branch);
    if (branches.empty()) {
      left_out.push_back({choice.reach[k].tube, disconnectedReason(between, conditions.start.has_value()), between});
      continue;
    }
    in_part.reach.push_back(std::move(choice.reach[k]));
    in_part.branches.push_back(std::move(branches));
  }
  choice = std::move(in_part);
  return left_out;
}

RealOrder orderWithRealMoves(const PlanContext& context, const VisitChoice& choice, TravelNetwork& network,
                             bool gives_up_if_parted, std::size_t& rounds_done) {
  RealOrder best;
  const VisitPlanOptions& options = context.options;
  Route route = routeOf(choice, context.speeds, options.conditions);
  const std::vector<int> zones = zonesOf(choice.tubes(), options.conditions);
  if (const PostureTable table(route); isForExactOrder(table, options.order.most_exact_work))
    return FewTubes(context, choice, table, zones, network).order();
  VisitOrderOptions ordering = options.order;
  ordering.seed = options.seed;
  ordering.stop = context.hooks.stop;
  keepFromBefore(context, choice, route, ordering);
  best.has_kept_order = !ordering.start.empty();
  EdgePenalties penalties;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < options.reprice_rounds && !context.isStopped(); ++round) {
    if (penalties.size()) addExtraTimes(penalties, choice, route);
    const VisitOrder order = orderOfRound(context, route, zones, rounds_done++, ordering);
    if (round == 0) {
      best.lower_bound = order.lower_bound;
      best.has_kept_bound = order.lower_bound == ordering.known_bound;
      ordering.with_bound = false;
      ordering.start_kicks = 0;
      ordering.kicks_per_visit /= kLaterKicksShare;
      ordering.least_kicks /= kLaterKicksShare;
    }
    if (order.order.empty()) {
      best.reason = order.reason;
      break;
    }
    std::vector<Stop> stops = stopsOf(order, choice, options.conditions);
    (ordering.start.empty() ? ordering.hint : ordering.start) = order.order;
    const Priced priced = priceOrder(context, stops, network, penalties);
    if (priced.is_parted && !best.is_parted) best.between = priced.between;
    best.is_parted |= priced.is_parted;
    if (priced.time < least || best.stops.empty()) best.stops = std::move(stops);
    least = std::min(least, priced.time);
    if (!priced.learnt || (best.is_parted && gives_up_if_parted)) break;
  }
  return best;
}

std::vector<Stop> joinRuns(const std::vector<Stop>& stops, const VisitChoice& choice, TravelNetwork& network,
                           const VisitConditions& conditions, std::vector<UnreachableTube>& left_out) {
  const bool is_bound = conditions.start || conditions.end || !conditions.zones.empty();
  return is_bound ? joinInOrder(stops, choice, network, left_out) : joinAnywhere(stops, choice, network, left_out);
}

}  // namespace tubeplan::planner
