#include "planner/visit_plan.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <set>

#include "planner/order/zoned_order.hpp"
#include "planner/plan_proof.hpp"
#include "planner/real_order.hpp"

namespace tubeplan::planner {

namespace {

/// Every tube on its own, so in parallel; results stand in the order of the list.
std::vector<TubeReach> reachAll(const ArmClearance& clearance, const std::vector<int>& tubes,
                                const TubeReachOptions& options, const PlanHooks& hooks, PlanCache& cache,
                                VisitPlan& plan) {
  std::vector<TubeReach> reach(tubes.size());
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < tubes.size(); ++k) {
    if (const auto known = cache.reach.find(tubes[k]); known != cache.reach.end())
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
    cache.reach[found.tube] = found;
    tell(hooks, "reach", ++done, tubes.size());
    keep(hooks, cache);
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

/// Lays the segments out along stops that can all be travelled between; gives the ends of each.
std::vector<MotionEnds> laySegments(const std::vector<Stop>& stops, const VisitChoice& choice,
                                    const VisitConditions& conditions, TravelNetwork& network, VisitPlan& plan) {
  std::vector<MotionEnds> ends;
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
    plan.visits.push_back({tube.tube, branch, conditions.dwellAt(tube.tube)});
    plan.segments.push_back(segmentOf(SegmentKind::kApproach, visit, branch.approach));
    plan.segments.push_back(
        segmentOf(SegmentKind::kRetreat, visit, {branch.approach.rbegin(), branch.approach.rend()}));
    ends.insert(ends.end(), 2, {network.postureOf(stops[k]), network.postureOf(stops[k])});
  }
  return ends;
}

/// The figures to compare with, of the visits that are in the plan.
void compareTimes(const Workcell& cell, const std::vector<Stop>& stops, const VisitChoice& choice,
                  const JointSpeeds& speeds, const VisitConditions& conditions, VisitPlan& plan) {
  VisitChoice kept;
  std::vector<int> rows, columns;
  for (const Stop& stop : stops) {
    if (stop.visit < 0) continue;
    kept.reach.push_back(choice.reach[static_cast<std::size_t>(stop.visit)]);
    kept.branches.push_back(choice.branches[static_cast<std::size_t>(stop.visit)]);
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(kept.reach.back().tube)];
    rows.push_back(tube.row);
    columns.push_back(tube.column);
  }
  const Route route = routeOf(kept, speeds, conditions);
  const std::vector<int> zones = zonesOf(kept.tubes(), conditions);
  if (kept.reach.size() < choice.reach.size()) plan.lower_bound = zonedBound(route, zones);
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

/// What speaks against resting in the start or the end posture; empty where nothing does.
std::string findEndProblem(const ArmClearance& clearance, const VisitPlanOptions& options) {
  const auto problemAt = [&](const std::string& name, const Eigen::VectorXd& q) -> std::string {
    for (int j = 0; j < q.size(); ++j) {
      const auto& joint = clearance.cell().arm.joint(j);
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
  VisitPlan plan;
  const ArmClearance clearance(cell, options.reach.padding);
  const JointSpeeds speeds = jointSpeedsOf(cell.arm);
  std::vector<TubeReach> reach = reachAll(clearance, tubes, options.reach, hooks, cache, plan);
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
  const std::set<MotionEnds> travels_before = keysOf(cache.travels);
  VisitChoice choice = allBranches(std::move(reach));
  TravelRoadmap roadmap(clearance, options);
  auto network = std::make_unique<TravelNetwork>(clearance, choice.reach, roadmap, options, cache);
  std::size_t rounds = 0;
  RealOrder order = orderWithRealMoves(choice, *network, options, true, hooks, cache, rounds);
  if (order.is_parted && !shouldStop(hooks)) {
    // No order avoids a move that cannot be made: what cannot be joined is left out, and the rest ordered anew.
    const auto left_out = keepOnePart(choice, roadmap.get(), conditions, order.between);
    plan.unreachable.insert(plan.unreachable.end(), left_out.begin(), left_out.end());
    network = std::make_unique<TravelNetwork>(clearance, choice.reach, roadmap, options, cache);
    order = orderWithRealMoves(choice, *network, options, false, hooks, cache, rounds);
  }
  if (shouldStop(hooks)) return stopped(plan);
  if (order.stops.empty()) return withoutOrder(std::move(plan), order.reason);
  plan.lower_bound = order.lower_bound;
  const std::vector<Stop> stops = joinRuns(order.stops, choice, *network, conditions, plan.unreachable);
  if (!keepsEnds(stops, conditions))
    return withoutOrder(std::move(plan), "no path was found between the start or end posture and the tubes");
  const std::vector<MotionEnds> ends = laySegments(stops, choice, conditions, *network, plan);
  for (const auto& [a, b] : ends) plan.kept.travels += a != b && travels_before.contains(std::minmax(a, b));
  if (!proveAll(clearance, options, ends, hooks, cache, plan) || shouldStop(hooks)) return stopped(plan);
  timeSegments(speeds, plan);
  compareTimes(cell, stops, choice, speeds, conditions, plan);
  cache.visiting_order.clear();
  for (const auto& visit : plan.visits) cache.visiting_order.push_back(visit.tube);
  plan.status = VisitPlanStatus::kPlanned;
  return plan;
}

}  // namespace tubeplan::planner
