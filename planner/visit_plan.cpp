#include "planner/visit_plan.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <set>

#include "planner/branch_choice.hpp"
#include "planner/kept_order.hpp"
#include "planner/one_tree_bound.hpp"
#include "planner/plan_proof.hpp"
#include "planner/travel_network.hpp"
#include "planner/zoned_order.hpp"

namespace tubeplan::planner {

namespace {

/// Every tube on its own, so in parallel; results stand in the order of the list.
std::vector<TubeReach> reachAll(const ArmClearance& clearance, const std::vector<int>& tubes,
                                const TubeReachOptions& options, const PlanHooks& hooks, PlanMemory& memory,
                                VisitPlan& plan) {
  std::vector<TubeReach> reach(tubes.size());
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < tubes.size(); ++k) {
    if (const auto known = memory.reach.find(tubes[k]); known != memory.reach.end())
      reach[k] = known->second;
    else
      open.push_back(k);
  }
  plan.kept.reach = static_cast<int>(tubes.size() - open.size());
  std::mutex telling;
  std::size_t done = tubes.size() - open.size();
  oneapi::tbb::parallel_for(std::size_t{0}, open.size(), [&](std::size_t k) {
    if (shouldStop(hooks)) return;
    TubeReach& found = reach[open[k]];
    found = reachTube(clearance, tubes[open[k]], options);
    const std::lock_guard lock(telling);
    memory.reach[found.tube] = found;
    tell(hooks, "reach", ++done, tubes.size());
    keep(hooks, memory);
  });
  return reach;
}

Route routeOf(const std::vector<TubeReach>& reach, const JointSpeeds& speeds, const VisitConditions& conditions) {
  Route route;
  route.speeds = speeds;
  route.start = conditions.start;
  route.end = conditions.end;
  for (const auto& tube : reach) {
    Visit visit;
    for (const auto& branch : tube.branches) visit.branches.push_back(branch.approach.front());
    route.visits.push_back(std::move(visit));
  }
  return route;
}

std::vector<Stop> stopsOf(const VisitOrder& order) {
  std::vector<Stop> stops;
  for (std::size_t k = 0; k < order.order.size(); ++k) stops.push_back({order.order[k], order.branches[k]});
  return stops;
}

/// With the start and the end posture put where they belong.
std::vector<Stop> withEnds(std::vector<Stop> stops, const VisitConditions& conditions) {
  if (conditions.start) stops.insert(stops.begin(), {kStartPosture, 0});
  if (conditions.end) stops.push_back({kEndPosture, 0});
  return stops;
}

/// Plans the moves that an order chose and puts their extra time into the table; true when something new was learnt.
bool priceOrder(const std::vector<Stop>& stops, TravelNetwork& network, const JointSpeeds& speeds,
                EdgePenalties& penalties, const PlanHooks& hooks, const PlanMemory& memory) {
  bool learnt = false;
  for (std::size_t k = 0; k + 1 < stops.size() && !shouldStop(hooks); ++k) {
    const Stop a = stops[k], b = stops[k + 1];
    tell(hooks, "travel", k + 1, stops.size() - 1);
    const double time = network.timeOf(network.between(a, b));
    keep(hooks, memory);
    const double extra = time - moveDuration(network.standoff(a), network.standoff(b), speeds);
    if (extra <= 1e-9 || penalties(a.visit, a.branch, b.visit, b.branch) > 0) continue;
    penalties.set(a.visit, a.branch, b.visit, b.branch, extra);
    learnt = true;
  }
  return learnt;
}

/// The order of one round, from the memory where it has it. An order kept from another list that cannot avoid a
/// forbidden move is found anew.
VisitOrder orderOfRound(const Route& route, const std::vector<int>& zones, std::size_t round,
                        VisitOrderOptions& ordering, const PlanHooks& hooks, PlanMemory& memory) {
  if (round < memory.orders.size()) return memory.orders[round];
  VisitOrder order = orderByZones(route, zones, ordering);
  if (order.status == VisitOrderStatus::kForbiddenMove && !ordering.start.empty()) {
    ordering.start.clear();
    order = orderByZones(route, zones, ordering);
  }
  if (shouldStop(hooks)) return order;
  memory.orders.push_back(order);
  keep(hooks, memory);
  return order;
}

std::vector<int> tubesOf(const std::vector<TubeReach>& reach) {
  std::vector<int> tubes;
  for (const auto& tube : reach) tubes.push_back(tube.tube);
  return tubes;
}

/// Order on the metric, plan the chosen moves, put in what they really cost, and order again until no move surprises.
std::vector<Stop> orderWithRealMoves(Route& route, const std::vector<int>& zones, TravelNetwork& network,
                                     VisitOrderOptions ordering, const VisitPlanOptions& options,
                                     const PlanHooks& hooks, PlanMemory& memory, VisitPlan& plan) {
  EdgePenalties penalties;
  std::vector<Stop> best;
  for (int round = 0; round < options.reprice_rounds && !shouldStop(hooks); ++round) {
    route.extra_time = penalties.size() ? ExtraTime(std::cref(penalties)) : ExtraTime();
    const VisitOrder order = orderOfRound(route, zones, static_cast<std::size_t>(round), ordering, hooks, memory);
    if (round == 0) plan.lower_bound = order.lower_bound;
    ordering.with_bound = false;
    if (order.order.empty()) {
      plan.reason = order.reason;
      break;
    }
    best = withEnds(stopsOf(order), options.conditions);
    if (!ordering.start.empty()) ordering.start = order.order;
    if (!priceOrder(best, network, route.speeds, penalties, hooks, memory)) break;
  }
  route.extra_time = nullptr;
  return best;
}

std::string inTheWay(const MotionPlan& plan) {
  return plan.reason.empty() ? "no path from the tube before it" : "no path from the tube before it: " + plan.reason;
}

PathSegment segmentOf(SegmentKind kind, int visit, std::vector<Eigen::VectorXd> waypoints) {
  PathSegment segment;
  segment.kind = kind;
  segment.visit = visit;
  segment.waypoints = std::move(waypoints);
  return segment;
}

bool isFree(TravelNetwork& network, Stop a, Stop b) { return network.between(a, b).status == MotionPlanStatus::kFree; }

/// The order cut where no travel was found: stretches that can be travelled through.
std::vector<std::vector<Stop>> travelledRuns(const std::vector<Stop>& stops, TravelNetwork& network) {
  std::vector<std::vector<Stop>> runs;
  for (const Stop& stop : stops) {
    if (runs.empty() || !isFree(network, runs.back().back(), stop)) runs.emplace_back();
    runs.back().push_back(stop);
  }
  return runs;
}

void leaveOut(const std::vector<Stop>& run, const MotionPlan& travel, const std::vector<TubeReach>& reach,
              VisitPlan& plan) {
  for (const Stop& stop : run)
    if (stop.visit >= 0)
      plan.unreachable.push_back({reach[static_cast<std::size_t>(stop.visit)].tube, inTheWay(travel), travel.tightest});
}

/// Keeps the longest stretch and what follows on either side of it without a change of order; the rest is named
/// unreachable.
std::vector<Stop> joinInOrder(const std::vector<Stop>& stops, const std::vector<TubeReach>& reach,
                              TravelNetwork& network, VisitPlan& plan) {
  const auto runs = travelledRuns(stops, network);
  const auto longest =
      std::max_element(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  std::vector<Stop> kept = *longest;
  for (auto run = longest + 1; run != runs.end(); ++run) {
    if (isFree(network, kept.back(), run->front()))
      kept.insert(kept.end(), run->begin(), run->end());
    else
      leaveOut(*run, network.between(kept.back(), run->front()), reach, plan);
  }
  for (auto run = std::make_reverse_iterator(longest); run != runs.rend(); ++run) {
    if (isFree(network, run->back(), kept.front()))
      kept.insert(kept.begin(), run->begin(), run->end());
    else
      leaveOut(*run, network.between(run->back(), kept.front()), reach, plan);
  }
  return kept;
}

/// Keeps the longest stretch and what can be joined to either end of it; the rest is named unreachable.
std::vector<Stop> joinRuns(const std::vector<Stop>& stops, const std::vector<TubeReach>& reach, TravelNetwork& network,
                           VisitPlan& plan) {
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
      leaveOut(run, network.between(kept.back(), run.front()), reach, plan);
    }
  }
  return kept;
}

/// Lays the segments out along stops that can all be travelled between; gives the ends of each.
std::vector<MotionEnds> laySegments(const std::vector<Stop>& stops, const std::vector<TubeReach>& reach,
                                    const VisitConditions& conditions, TravelNetwork& network, VisitPlan& plan) {
  std::vector<MotionEnds> ends;
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const bool is_visit = stops[k].visit >= 0;
    const int visit = static_cast<int>(plan.visits.size()) - (is_visit ? 0 : 1);
    if (k > 0) {
      const MotionPlan& travel = network.between(stops[k - 1], stops[k]);
      plan.segments.push_back(segmentOf(SegmentKind::kTravel, visit, travel.waypoints));
      plan.segments.back().flows = travel.flows;
      plan.detours += travel.waypoints.size() > 2;
      ends.push_back({network.postureOf(stops[k - 1]), network.postureOf(stops[k])});
    }
    if (!is_visit) continue;
    const auto& tube = reach[static_cast<std::size_t>(stops[k].visit)];
    const auto& branch = tube.branches[static_cast<std::size_t>(stops[k].branch)];
    plan.visits.push_back({tube.tube, branch, conditions.dwellAt(tube.tube)});
    plan.segments.push_back(segmentOf(SegmentKind::kApproach, visit, branch.approach));
    plan.segments.push_back(
        segmentOf(SegmentKind::kRetreat, visit, {branch.approach.rbegin(), branch.approach.rend()}));
    ends.insert(ends.end(), 2, {network.postureOf(stops[k]), network.postureOf(stops[k])});
  }
  return ends;
}

/// The figures to compare with, of the visits that are in the plan.
void compareTimes(const Workcell& cell, const std::vector<Stop>& stops, const std::vector<TubeReach>& reach,
                  const JointSpeeds& speeds, const VisitConditions& conditions, VisitPlan& plan) {
  std::vector<TubeReach> kept;
  std::vector<int> rows, columns;
  for (const Stop& stop : stops) {
    if (stop.visit < 0) continue;
    kept.push_back(reach[static_cast<std::size_t>(stop.visit)]);
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(kept.back().tube)];
    rows.push_back(tube.row);
    columns.push_back(tube.column);
  }
  const Route route = routeOf(kept, speeds, conditions);
  const std::vector<int> zones = zonesOf(tubesOf(kept), conditions);
  if (kept.size() < reach.size()) plan.lower_bound = zonedBound(route, zones);
  plan.row_by_row_time = rowByRowTime(route, zones, rows, columns);
  plan.gap = plan.lower_bound > 0 ? (plan.travel_time - plan.lower_bound) / plan.lower_bound : 0;
}

void timeSegments(const JointSpeeds& speeds, VisitPlan& plan) {
  plan.travel_time = plan.total_time = 0;
  for (const auto& segment : plan.segments) {
    const double duration = durationOf(segment, speeds);
    plan.total_time += duration;
    if (segment.kind == SegmentKind::kTravel) plan.travel_time += duration;
  }
  for (const auto& visit : plan.visits) plan.total_time += visit.dwell;
}

/// What speaks against resting in the start or the end posture; empty where nothing does.
std::string findEndProblem(const ArmClearance& clearance, const VisitPlanOptions& options) {
  const auto problemAt = [&](const std::string& name, const Eigen::VectorXd& q) -> std::string {
    const auto active = deflection::activeRows(clearance.cell().arm);
    for (int j = 0; j < q.size(); ++j) {
      const auto& joint =
          clearance.cell().arm.rows[static_cast<std::size_t>(active[static_cast<std::size_t>(j)])].joint;
      if (!(q[j] >= joint.lower && q[j] <= joint.upper)) return name + ": " + joint.name + " is past its limit";
    }
    const Clearance there = clearance.withSpare(q, ContactRule::kTravel, options.reach.spare);
    return there.margin >= 0 ? "" : name + ": " + describe(there);
  };
  std::string problem;
  if (options.conditions.start) problem = problemAt("the start posture", *options.conditions.start);
  if (problem.empty() && options.conditions.end) problem = problemAt("the end posture", *options.conditions.end);
  return problem;
}

/// Whether the stops still begin and end where they must.
bool keepsEnds(const std::vector<Stop>& stops, const VisitConditions& conditions) {
  return (!conditions.start || stops.front().visit == kStartPosture) &&
         (!conditions.end || stops.back().visit == kEndPosture);
}

VisitPlan withoutOrder(VisitPlan plan, std::string reason) {
  plan.status = VisitPlanStatus::kNoOrder;
  plan.reason = std::move(reason);
  return plan;
}

std::set<MotionEnds> keysOf(const std::map<MotionEnds, MotionPlan>& travels) {
  std::set<MotionEnds> keys;
  for (const auto& [ends, plan] : travels) keys.insert(ends);
  return keys;
}

VisitPlan stopped(VisitPlan plan) {
  plan.status = VisitPlanStatus::kStopped;
  plan.reason = "stopped before the plan was complete";
  return plan;
}

}  // namespace

std::string_view nameOf(SegmentKind kind) {
  static constexpr std::array<std::string_view, 3> kNames{"travel", "approach", "retreat"};
  return kNames.at(static_cast<std::size_t>(kind));
}

JointSpeeds jointSpeedsOf(const deflection::Arm& arm) {
  const auto active = deflection::activeRows(arm);
  JointSpeeds speeds{Eigen::VectorXd(active.size()), Eigen::VectorXd(active.size())};
  for (int k = 0; k < speeds.max_speed.size(); ++k) {
    speeds.max_speed[k] = arm.rows[active[k]].joint.max_speed;
    speeds.max_acceleration[k] = arm.rows[active[k]].joint.max_acceleration;
  }
  return speeds;
}

VisitPlan planVisits(const Workcell& cell, const std::vector<int>& tubes, const VisitPlanOptions& options,
                     const PlanHooks& hooks) {
  PlanMemory memory;
  return planVisits(cell, tubes, options, hooks, memory);
}

VisitPlan planVisits(const Workcell& cell, const std::vector<int>& tubes, const VisitPlanOptions& options,
                     const PlanHooks& hooks, PlanMemory& memory) {
  VisitPlan plan;
  const ArmClearance clearance(cell);
  const JointSpeeds speeds = jointSpeedsOf(cell.arm);
  std::vector<TubeReach> reach = reachAll(clearance, tubes, options.reach, hooks, memory, plan);
  if (shouldStop(hooks)) return stopped(plan);
  for (const auto& tube : reach)
    if (tube.status == ReachStatus::kUnreachable) plan.unreachable.push_back({tube.tube, tube.reason, tube.blocking});
  std::erase_if(reach, [](const TubeReach& tube) { return tube.status != ReachStatus::kReachable; });
  if (reach.empty()) {
    plan.status = VisitPlanStatus::kNothingReachable;
    plan.reason = "none of the tubes can be reached";
    return plan;
  }
  const VisitConditions& conditions = options.conditions;
  if (std::string problem = findEndProblem(clearance, options); !problem.empty())
    return withoutOrder(std::move(plan), std::move(problem));
  Route route = routeOf(reach, speeds, conditions);
  const std::set<MotionEnds> travels_before = keysOf(memory.travels);
  TravelNetwork network(clearance, reach, speeds, options, memory);
  VisitOrderOptions ordering = options.order;
  ordering.seed = options.seed;
  ordering.stop = hooks.stop;
  ordering.start = keptOrder(route, tubesOf(reach), memory.visiting_order);
  std::vector<Stop> stops =
      orderWithRealMoves(route, zonesOf(tubesOf(reach), conditions), network, ordering, options, hooks, memory, plan);
  if (shouldStop(hooks)) return stopped(plan);
  if (stops.empty()) return withoutOrder(std::move(plan), plan.reason);
  const bool is_bound = conditions.start || conditions.end || !conditions.zones.empty();
  stops = is_bound ? joinInOrder(stops, reach, network, plan) : joinRuns(stops, reach, network, plan);
  if (!keepsEnds(stops, conditions))
    return withoutOrder(std::move(plan), "no path was found between the start or end posture and the tubes");
  const std::vector<MotionEnds> ends = laySegments(stops, reach, conditions, network, plan);
  for (const auto& [a, b] : ends) plan.kept.travels += a != b && travels_before.contains(std::minmax(a, b));
  if (!proveAll(clearance, options, ends, hooks, memory, plan) || shouldStop(hooks)) return stopped(plan);
  timeSegments(speeds, plan);
  compareTimes(cell, stops, reach, speeds, conditions, plan);
  memory.visiting_order.clear();
  for (const auto& visit : plan.visits) memory.visiting_order.push_back(visit.tube);
  plan.status = VisitPlanStatus::kPlanned;
  return plan;
}

}  // namespace tubeplan::planner
