#include "planner/visit_plan.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <set>
#include <tuple>

#include "planner/departure.hpp"
#include "planner/order/zoned_order.hpp"
#include "planner/plan_context.hpp"
#include "planner/plan_proof.hpp"
#include "planner/real_order.hpp"

namespace tubeplan::planner {

namespace {

/// Computes the reach of every tube, in parallel; results are in the order of `tubes`.
std::vector<TubeReach> reachAll(const PlanContext& context, const std::vector<int>& tubes, VisitPlan& plan) {
  auto& cached = context.cache.reach;
  std::vector<TubeReach> reach(tubes.size());
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < tubes.size(); ++k) {
    if (const auto known = cached.find(tubes[k]); known != cached.end())
      reach[k] = known->second;
    else
      open.push_back(k);
  }
  plan.kept.reach = static_cast<int>(tubes.size() - open.size());
  std::mutex mutex;
  std::size_t done = tubes.size() - open.size();
  oneapi::tbb::parallel_for(std::size_t{0}, open.size(), [&](std::size_t k) {
    if (context.isStopped()) return;
    TubeReach& found = reach[open[k]];
    found = reachTube(context.clearance, tubes[open[k]], context.options.reach);
    const std::lock_guard lock(mutex);
    cached[found.tube] = found;
    context.showProgress("reach", ++done, tubes.size());
    context.keepCache();
  });
  return reach;
}

PathSegment segmentOf(SegmentKind kind, int visit, std::vector<Eigen::VectorXd> waypoints) {
  PathSegment segment;
  segment.kind = kind;
  segment.visit = visit;
  segment.waypoints = std::move(waypoints);
  return segment;
}

/// Adds the segments along `stops` to the plan; a travel must exist between consecutive stops. Returns the ends of each
/// segment.
std::vector<MotionEnds> laySegments(const PlanContext& context, const std::vector<Stop>& stops,
                                    const std::optional<Departure>& departure, const VisitChoice& choice,
                                    TravelNetwork& network, VisitPlan& plan) {
  std::vector<MotionEnds> ends;
  if (departure) {
    plan.departed = departure->tube;
    plan.segments.push_back(segmentOf(SegmentKind::kRetreat, -1, departure->waypoints));
    ends.push_back({network.postureOf(stops.front()), network.postureOf(stops.front())});
  }
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const bool is_visit = stops[k].visit >= 0;
    const int visit = static_cast<int>(plan.visits.size()) - (is_visit ? 0 : 1);
    if (k > 0) {
      const MotionPlan& travel = network.between(stops[k - 1], stops[k]);
      plan.segments.push_back(segmentOf(SegmentKind::kTravel, visit, travel.waypoints));
      plan.segments.back().flows = travel.flows;
      if (std::isnan(travel.line_deviation)) {
        plan.detours += travel.waypoints.size() > 2;
      } else {
        ++plan.lines;
        plan.line_deviation = std::fmax(plan.line_deviation, travel.line_deviation);
      }
      ends.push_back({network.postureOf(stops[k - 1]), network.postureOf(stops[k])});
    }
    if (!is_visit) continue;
    const auto& tube = choice.reach[static_cast<std::size_t>(stops[k].visit)];
    const auto& branch = tube.branches[static_cast<std::size_t>(stops[k].branch)];
    plan.visits.push_back({tube.tube, branch, context.options.conditions.dwellAt(tube.tube)});
    plan.segments.push_back(segmentOf(SegmentKind::kApproach, visit, branch.approach));
    plan.segments.push_back(
        segmentOf(SegmentKind::kRetreat, visit, {branch.approach.rbegin(), branch.approach.rend()}));
    ends.insert(ends.end(), 2, {network.postureOf(stops[k]), network.postureOf(stops[k])});
  }
  return ends;
}

bool hasAllBranches(const VisitChoice& choice) {
  for (std::size_t k = 0; k < choice.reach.size(); ++k)
    if (choice.branches[k].size() < choice.reach[k].branches.size()) return false;
  return true;
}

/// Sets the lower bound and the row-by-row time with which the travel time is compared, for the visits that remain in
/// the plan.
void compareTimes(const PlanContext& context, const std::vector<Stop>& stops, const VisitChoice& choice,
                  VisitPlan& plan) {
  const VisitConditions& conditions = context.options.conditions;
  VisitChoice kept;
  std::vector<int> rows, columns;
  for (const Stop& stop : stops) {
    if (stop.visit < 0) continue;
    kept.reach.push_back(choice.reach[static_cast<std::size_t>(stop.visit)]);
    kept.branches.push_back(choice.branches[static_cast<std::size_t>(stop.visit)]);
    const auto& tube = context.cell.sheet.tubes[static_cast<std::size_t>(kept.reach.back().tube)];
    rows.push_back(tube.row);
    columns.push_back(tube.column);
  }
  const Route route = routeOf(kept, context.speeds, conditions);
  const std::vector<int> zones = zonesOf(kept.tubes(), conditions);
  if (kept.reach.size() < choice.reach.size() || !hasAllBranches(kept)) {
    // The bound covers all branches, also those excluded from the choice, because it is not proved that they cannot be
    // connected.
    OneTreeOptions bound = context.options.order.bound;
    bound.stop = context.hooks.stop;
    plan.lower_bound =
        zonedBound(routeOf(allBranches(std::move(kept.reach)), context.speeds, conditions), zones, bound);
  }
  plan.row_by_row_time = rowByRowTime(route, zones, rows, columns);
  plan.optimality_gap = plan.lower_bound > 0 ? (plan.travel_time - plan.lower_bound) / plan.lower_bound : 0;
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

/// Returns the reason why the arm cannot rest in the start posture or the end posture; empty if it can.
std::string findEndProblem(const PlanContext& context) {
  const auto problemAt = [&](const std::string& name, const Eigen::VectorXd& q) -> std::string {
    for (int j = 0; j < q.size(); ++j) {
      const auto& joint = context.cell.arm.joint(j);
      if (!(q[j] >= joint.lower && q[j] <= joint.upper)) return name + ": " + joint.name + " is past its limit";
    }
    const Clearance clearance = context.clearance.withSpare(q, ContactRule::kTravel, context.options.reach.spare);
    return clearance.margin >= 0 ? "" : name + ": " + describe(clearance);
  };
  const auto& [start, end] = std::tie(context.options.conditions.start, context.options.conditions.end);
  std::string problem;
  if (start) problem = problemAt("the start posture", *start);
  if (problem.empty() && end) problem = problemAt("the end posture", *end);
  return problem;
}

/// Finds the order of visits. If no order avoids moves between disconnected parts of the free space, searches for
/// connections between these parts and orders the visits again. Tubes that still cannot be connected are removed from
/// `choice`.
RealOrder orderInOnePart(const PlanContext& context, TravelRoadmap& roadmap, VisitChoice& choice, VisitPlan& plan) {
  std::size_t rounds = 0;
  {
    TravelNetwork network(context, choice.reach, roadmap);
    RealOrder order = orderWithRealMoves(context, choice, network, true, rounds);
    if (!order.is_parted || context.isStopped()) return order;
    if (roadmap.bridge(standoffsOf(choice, context.options.conditions))) {
      TravelNetwork bridged(context, choice.reach, roadmap);
      order = orderWithRealMoves(context, choice, bridged, true, rounds);
      if (!order.is_parted || context.isStopped()) return order;
    }
    const auto left_out = keepOnePart(choice, roadmap.get(), context.options.conditions, order.between);
    plan.unreachable.insert(plan.unreachable.end(), left_out.begin(), left_out.end());
  }
  TravelNetwork network(context, choice.reach, roadmap);
  return orderWithRealMoves(context, choice, network, false, rounds);
}

/// Returns true if the stops still begin and end in the required postures.
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

/// Stores the results from which the next plan of a changed list starts.
void keepForTheNext(const PlanContext& context, const std::vector<Stop>& stops, const VisitPlan& plan) {
  PlanCache& cache = context.cache;
  const VisitConditions& conditions = context.options.conditions;
  cache.visiting_order.clear();
  cache.visiting_branches.clear();
  for (const auto& visit : plan.visits) cache.visiting_order.push_back(visit.tube);
  for (const Stop& stop : stops)
    if (stop.visit >= 0) cache.visiting_branches.push_back(stop.branch);
  cache.bound = {};
  if (conditions.zones.empty()) cache.bound = {plan.lower_bound, conditions.start, conditions.end};
}

VisitPlan stopped(VisitPlan plan) {
  plan.status = VisitPlanStatus::kStopped;
  plan.reason = "stopped before the plan was complete";
  return plan;
}

/// Plans the visits; the start posture, if there is one, is the end of the departure.
VisitPlan planTravels(const PlanContext& context, const std::vector<int>& tubes,
                      const std::optional<Departure>& departure) {
  const VisitConditions& conditions = context.options.conditions;
  VisitPlan plan;
  std::vector<TubeReach> reach = reachAll(context, tubes, plan);
  if (context.isStopped()) return stopped(plan);
  for (const auto& tube : reach)
    if (tube.status == ReachStatus::kUnreachable) plan.unreachable.push_back({tube.tube, tube.reason, tube.blocking});
  std::erase_if(reach, [](const TubeReach& tube) { return tube.status != ReachStatus::kReachable; });
  if (reach.empty()) {
    plan.status = VisitPlanStatus::kNothingReachable;
    plan.reason = "none of the tubes can be reached";
    return plan;
  }
  if (std::string problem = findEndProblem(context); !problem.empty())
    return withoutOrder(std::move(plan), std::move(problem));
  const std::set<MotionEnds> travels_before = keysOf(context.cache.travels);
  VisitChoice choice = allBranches(std::move(reach));
  TravelRoadmap roadmap(context);
  const RealOrder order = orderInOnePart(context, roadmap, choice, plan);
  if (context.isStopped()) return stopped(plan);
  if (order.stops.empty())
    return withoutOrder(std::move(plan),
                        order.reason.empty() ? "no path was found from the start posture to any tube" : order.reason);
  plan.lower_bound = order.lower_bound;
  plan.kept.order = order.has_kept_order;
  plan.kept.bound = order.has_kept_bound;
  TravelNetwork network(context, choice.reach, roadmap);
  const std::vector<Stop> stops = joinRuns(order.stops, choice, network, conditions, plan.unreachable);
  if (!keepsEnds(stops, conditions))
    return withoutOrder(std::move(plan), "no path was found between the start or end posture and the tubes");
  const std::vector<MotionEnds> ends = laySegments(context, stops, departure, choice, network, plan);
  for (const auto& [a, b] : ends) plan.kept.travels += a != b && travels_before.contains(std::minmax(a, b));
  if (!proveAll(context, ends, plan) || context.isStopped()) return stopped(plan);
  timeSegments(context.speeds, plan);
  compareTimes(context, stops, choice, plan);
  keepForTheNext(context, stops, plan);
  plan.status = VisitPlanStatus::kPlanned;
  return plan;
}

}  // namespace

std::string_view nameOf(SegmentKind kind) {
  static constexpr std::array<std::string_view, 3> kNames{"travel", "approach", "retreat"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::string_view nameOf(TravelKind kind) { return kind == TravelKind::kLine ? "line" : "joints"; }

std::optional<TravelKind> findTravelKind(std::string_view name) {
  for (const TravelKind kind : {TravelKind::kJoints, TravelKind::kLine})
    if (name == nameOf(kind)) return kind;
  return std::nullopt;
}

JointSpeeds jointSpeedsOf(const deflection::Arm& arm) {
  JointSpeeds speeds{Eigen::VectorXd(arm.jointCount()), Eigen::VectorXd(arm.jointCount())};
  for (int k = 0; k < speeds.max_speed.size(); ++k) {
    speeds.max_speed[k] = arm.joint(k).max_speed;
    speeds.max_acceleration[k] = arm.joint(k).max_acceleration;
  }
  return speeds;
}

VisitPlan planVisits(const Workcell& cell, const std::vector<int>& tubes, const VisitPlanOptions& options,
                     const PlanHooks& hooks) {
  PlanCache cache;
  return planVisits(cell, tubes, options, hooks, cache);
}

VisitPlan planVisits(const Workcell& cell, const std::vector<int>& tubes, const VisitPlanOptions& options,
                     const PlanHooks& hooks, PlanCache& cache) {
  const PlanContext context{cell, options, hooks, cache};
  const std::optional<Departure> departure = departureFrom(context);
  if (!departure) return planTravels(context, tubes, departure);
  VisitPlanOptions from_below = options;
  from_below.conditions.start = departure->waypoints.back();
  return planTravels(PlanContext{cell, from_below, hooks, cache}, tubes, departure);
}

}  // namespace tubeplan::planner
