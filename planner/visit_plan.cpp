#include "planner/visit_plan.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>

#include "planner/branch_choice.hpp"
#include "planner/one_tree_bound.hpp"
#include "planner/travel_network.hpp"

namespace tubeplan::planner {

namespace {

bool shouldStop(const PlanHooks& hooks) { return hooks.stop && hooks.stop(); }

void tell(const PlanHooks& hooks, std::string_view stage, std::size_t done, std::size_t total) {
  if (hooks.progress) hooks.progress(stage, done, total);
}

/// Every tube on its own, so in parallel; results stand in the order of the list.
std::vector<TubeReach> reachAll(const ArmClearance& clearance, const std::vector<int>& tubes,
                                const TubeReachOptions& options, const PlanHooks& hooks) {
  std::vector<TubeReach> reach(tubes.size());
  std::atomic<std::size_t> done = 0;
  std::mutex telling;
  oneapi::tbb::parallel_for(std::size_t{0}, tubes.size(), [&](std::size_t k) {
    if (shouldStop(hooks)) return;
    reach[k] = reachTube(clearance, tubes[k], options);
    ++done;
    const std::lock_guard lock(telling);
    tell(hooks, "reach", done, tubes.size());
  });
  return reach;
}

Route routeOf(const std::vector<TubeReach>& reach, const JointSpeeds& speeds) {
  Route route;
  route.speeds = speeds;
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

/// Plans the moves that an order chose and puts their extra time into the table; true when something new was learnt.
bool priceOrder(const std::vector<Stop>& stops, TravelNetwork& network, const JointSpeeds& speeds,
                EdgePenalties& penalties, const PlanHooks& hooks) {
  bool learnt = false;
  for (std::size_t k = 0; k + 1 < stops.size() && !shouldStop(hooks); ++k) {
    tell(hooks, "travel", k + 1, stops.size() - 1);
    if (network.knows(stops[k], stops[k + 1])) continue;
    const double time = network.timeOf(network.between(stops[k], stops[k + 1]));
    const double extra = time - moveDuration(network.standoff(stops[k]), network.standoff(stops[k + 1]), speeds);
    if (extra <= 1e-9) continue;
    penalties.set(stops[k].visit, stops[k].branch, stops[k + 1].visit, stops[k + 1].branch, extra);
    learnt = true;
  }
  return learnt;
}

/// Order on the metric, plan the chosen moves, put in what they really cost, and order again until no move surprises.
std::vector<Stop> orderWithRealMoves(Route& route, TravelNetwork& network, const VisitPlanOptions& options,
                                     const PlanHooks& hooks, VisitPlan& plan) {
  EdgePenalties penalties;
  std::vector<Stop> best;
  VisitOrderOptions ordering = options.order;
  ordering.seed = options.seed;
  for (int round = 0; round < options.reprice_rounds && !shouldStop(hooks); ++round) {
    route.extra_time = penalties.size() ? ExtraTime(std::cref(penalties)) : ExtraTime();
    const VisitOrder order = orderVisits(route, ordering);
    if (round == 0) plan.lower_bound = order.lower_bound;
    ordering.with_bound = false;
    if (order.order.empty()) {
      plan.reason = order.reason;
      break;
    }
    best = stopsOf(order);
    if (!priceOrder(best, network, route.speeds, penalties, hooks)) break;
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
      const MotionPlan& travel = network.between(kept.back(), run.front());
      for (const Stop& stop : run)
        plan.unreachable.push_back(
            {reach[static_cast<std::size_t>(stop.visit)].tube, inTheWay(travel), travel.tightest});
    }
  }
  return kept;
}

/// Lays the segments out along stops that can all be travelled between.
void laySegments(const std::vector<Stop>& stops, const std::vector<TubeReach>& reach, TravelNetwork& network,
                 VisitPlan& plan) {
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const auto& tube = reach[static_cast<std::size_t>(stops[k].visit)];
    const auto& branch = tube.branches[static_cast<std::size_t>(stops[k].branch)];
    const int visit = static_cast<int>(plan.visits.size());
    if (k > 0) {
      const MotionPlan& travel = network.between(stops[k - 1], stops[k]);
      plan.segments.push_back(segmentOf(SegmentKind::kTravel, visit, travel.waypoints));
      plan.detours += travel.waypoints.size() > 2;
    }
    plan.visits.push_back({tube.tube, branch});
    plan.segments.push_back(segmentOf(SegmentKind::kApproach, visit, branch.approach));
    plan.segments.push_back(
        segmentOf(SegmentKind::kRetreat, visit, {branch.approach.rbegin(), branch.approach.rend()}));
  }
}

/// The figures to compare with, of the visits that are in the plan.
void compareTimes(const Workcell& cell, const std::vector<Stop>& stops, const std::vector<TubeReach>& reach,
                  const JointSpeeds& speeds, VisitPlan& plan) {
  std::vector<TubeReach> kept;
  std::vector<int> rows, columns;
  for (const Stop& stop : stops) {
    kept.push_back(reach[static_cast<std::size_t>(stop.visit)]);
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(kept.back().tube)];
    rows.push_back(tube.row);
    columns.push_back(tube.column);
  }
  const Route route = routeOf(kept, speeds);
  if (kept.size() < reach.size()) plan.lower_bound = oneTreeBound(route).lower_bound;
  plan.row_by_row_time = rowByRowTime(route, rows, columns);
  plan.gap = plan.lower_bound > 0 ? (plan.travel_time - plan.lower_bound) / plan.lower_bound : 0;
}

/// Proves each segment once more, now to the accuracy that is reported.
void proveSegment(const ArmClearance& clearance, const VisitPlanOptions& options, PathSegment& segment) {
  MotionCheckOptions check = options.motion.check;
  check.accuracy = options.report_accuracy;
  const ContactRule rule = segment.kind == SegmentKind::kTravel ? ContactRule::kTravel : ContactRule::kApproach;
  const auto margin = [&](const Eigen::VectorXd& q) { return clearance.at(q, rule); };
  segment.margin = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < segment.waypoints.size(); ++k) {
    const MotionCheckResult result =
        checkMotion(segment.waypoints[k], segment.waypoints[k + 1], margin, clearance.travel(), check);
    const double proved =
        result.status == MotionCheckStatus::kFree ? result.proved_margin : -std::numeric_limits<double>::infinity();
    if (proved >= segment.margin) continue;
    segment.margin = proved;
    segment.tightest = result.tightest;
  }
}

void proveAll(const ArmClearance& clearance, const VisitPlanOptions& options, const PlanHooks& hooks, VisitPlan& plan) {
  std::atomic<std::size_t> done = 0;
  std::mutex telling;
  oneapi::tbb::parallel_for(std::size_t{0}, plan.segments.size(), [&](std::size_t k) {
    if (shouldStop(hooks)) return;
    // A retreat is its approach backwards: proved with it.
    if (plan.segments[k].kind != SegmentKind::kRetreat) proveSegment(clearance, options, plan.segments[k]);
    const std::lock_guard lock(telling);
    tell(hooks, "proof", ++done, plan.segments.size());
  });
  plan.min_margin = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < plan.segments.size(); ++k) {
    auto& segment = plan.segments[k];
    if (segment.kind == SegmentKind::kRetreat) {
      segment.margin = plan.segments[k - 1].margin;
      segment.tightest = plan.segments[k - 1].tightest;
    }
    if (segment.margin >= plan.min_margin) continue;
    plan.min_margin = segment.margin;
    plan.tightest = segment.tightest;
  }
}

void timeSegments(const JointSpeeds& speeds, VisitPlan& plan) {
  plan.travel_time = plan.total_time = 0;
  for (const auto& segment : plan.segments) {
    const double duration = timePolyline(segment.waypoints, speeds).duration;
    plan.total_time += duration;
    if (segment.kind == SegmentKind::kTravel) plan.travel_time += duration;
  }
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
  VisitPlan plan;
  const ArmClearance clearance(cell);
  const JointSpeeds speeds = jointSpeedsOf(cell.arm);
  std::vector<TubeReach> reach = reachAll(clearance, tubes, options.reach, hooks);
  if (shouldStop(hooks)) return stopped(plan);
  for (const auto& tube : reach)
    if (tube.status == ReachStatus::kUnreachable) plan.unreachable.push_back({tube.tube, tube.reason, tube.blocking});
  std::erase_if(reach, [](const TubeReach& tube) { return tube.status != ReachStatus::kReachable; });
  if (reach.empty()) {
    plan.status = VisitPlanStatus::kNothingReachable;
    plan.reason = "none of the tubes can be reached";
    return plan;
  }
  Route route = routeOf(reach, speeds);
  TravelNetwork network(clearance, reach, speeds, options);
  std::vector<Stop> stops = orderWithRealMoves(route, network, options, hooks, plan);
  if (shouldStop(hooks)) return stopped(plan);
  if (stops.empty()) {
    plan.status = VisitPlanStatus::kNoOrder;
    return plan;
  }
  stops = joinRuns(stops, reach, network, plan);
  laySegments(stops, reach, network, plan);
  proveAll(clearance, options, hooks, plan);
  if (shouldStop(hooks)) return stopped(plan);
  timeSegments(speeds, plan);
  compareTimes(cell, stops, reach, speeds, plan);
  plan.status = VisitPlanStatus::kPlanned;
  return plan;
}

std::vector<PathRow> samplePath(const VisitPlan& plan, const JointSpeeds& speeds, double max_step) {
  std::vector<PathRow> rows;
  double start = 0;
  for (std::size_t k = 0; k < plan.segments.size(); ++k) {
    const auto& segment = plan.segments[k];
    const auto timed = timePolyline(segment.waypoints, speeds);
    const auto samples = samplePolyline(timed, max_step);
    // A segment begins where the one before ended: that row is there already.
    for (std::size_t s = rows.empty() ? 0 : 1; s < samples.size(); ++s)
      rows.push_back({start + samples[s].time, static_cast<int>(k), segment.kind, samples[s].posture});
    start += timed.duration;
  }
  return rows;
}

}  // namespace tubeplan::planner
