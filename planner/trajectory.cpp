#include "planner/trajectory.hpp"

#include "planner/timing/flowing_timing.hpp"

namespace tubeplan::planner {

namespace {

/// A point of a move's profile: its time, the speed of the progress s there, and the acceleration of s after it.
struct MovePlace {
  double time, speed, acceleration;
};

std::vector<MovePlace> placesOf(const TimedMove& move) {
  if (move.ramp_time <= 0) return {{0, move.peak_speed, 0}};
  const double acceleration = move.peak_speed / move.ramp_time;
  std::vector<MovePlace> places{{0, 0, acceleration}};
  if (move.cruise_time > 0) places.push_back({move.ramp_time, move.peak_speed, 0});
  places.push_back({move.ramp_time + move.cruise_time, move.peak_speed, -acceleration});
  return places;
}

TrajectoryPoint pointAt(const TimedMove& move, const MovePlace& place, double start) {
  const Eigen::VectorXd way = move.to - move.from;
  return {start + place.time, sampleMove(move, place.time), place.speed * way, place.acceleration * way};
}

}  // namespace

std::vector<TrajectoryPoint> trajectoryOf(const VisitPlan& plan, const JointSpeeds& speeds, double least_step) {
  std::vector<TrajectoryPoint> points;
  double start = 0;
  const auto add = [&](TrajectoryPoint point) {
    if (points.empty() || point.time >= points.back().time + least_step) points.push_back(std::move(point));
  };
  for (const auto& segment : plan.segments) {
    if (segment.kind == SegmentKind::kRetreat && segment.visit >= 0)
      if (const double dwell = plan.visits[static_cast<std::size_t>(segment.visit)].dwell; dwell > 0) {
        const Eigen::VectorXd none = Eigen::VectorXd::Zero(segment.waypoints.front().size());
        add({start, segment.waypoints.front(), none, none});
        start += dwell;
      }
    if (segment.flows) {
      const TimedFlow flow = timeFlow(segment.waypoints, speeds);
      for (const FlowPhase& phase : flow.phases)
        add({start + phase.start, phase.from, phase.speed, phase.acceleration});
      start += flow.duration;
      continue;
    }
    for (const TimedMove& move : timePolyline(segment.waypoints, speeds).moves) {
      if (move.duration <= 0) continue;
      for (const MovePlace& place : placesOf(move)) add(pointAt(move, place, start));
      start += move.duration;
    }
  }
  if (plan.segments.empty()) return points;
  const Eigen::VectorXd end = plan.segments.back().waypoints.back(), none = Eigen::VectorXd::Zero(end.size());
  // Keep the end of the path: drop a point less than `least_step` before it instead.
  if (!points.empty() && start < points.back().time + least_step) points.pop_back();
  add({start, end, none, none});
  return points;
}

}  // namespace tubeplan::planner
