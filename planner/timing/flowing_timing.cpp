#include "planner/timing/flowing_timing.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace tubeplan::planner {

namespace {

using Eigen::VectorXd;

constexpr int kChords = 8;  // number of chords for a curved phase
// Each repair lengthens the legs that are too short for their corners, by the factor kRepair.
constexpr int kMostRepairs = 1000;
constexpr double kRepair = 1.02;

/// Legs of the polyline, without legs of zero length, with the duration of each leg at constant speed.
struct Legs {
  std::vector<VectorXd> ways;
  std::vector<double> times;

  [[nodiscard]] std::size_t size() const { return ways.size(); }
  /// Returns the joint speeds on leg k; zero before the first leg and after the last.
  [[nodiscard]] VectorXd speed(std::ptrdiff_t k) const {
    if (k < 0 || k >= static_cast<std::ptrdiff_t>(size())) return VectorXd::Zero(ways.front().size());
    return ways[static_cast<std::size_t>(k)] / times[static_cast<std::size_t>(k)];
  }
};

double slowest(const VectorXd& way, const VectorXd& limit) { return (way.array().abs() / limit.array()).maxCoeff(); }

Legs legsOf(const std::vector<VectorXd>& waypoints, const JointSpeeds& speeds) {
  Legs legs;
  for (std::size_t k = 1; k < waypoints.size(); ++k) {
    const VectorXd way = waypoints[k] - waypoints[k - 1];
    if (way.isZero(0)) continue;
    legs.ways.push_back(way);
    // A leg that is entered and left at speed may be faster than a rest-to-rest move, so repairs start from half the
    // rest-to-rest time.
    legs.times.push_back(
        std::max(slowest(way, speeds.max_speed), 0.5 * std::sqrt(slowest(way, speeds.max_acceleration))));
  }
  return legs;
}

/// Returns the duration of the speed change at each corner [s], including those from and to rest at the ends.
std::vector<double> cornerTimes(const Legs& legs, const JointSpeeds& speeds) {
  std::vector<double> times;
  for (std::ptrdiff_t k = 0; k <= static_cast<std::ptrdiff_t>(legs.size()); ++k)
    times.push_back(slowest(legs.speed(k) - legs.speed(k - 1), speeds.max_acceleration));
  return times;
}

/// Increases the durations of legs until each leg has time for half of the corner at either end. Returns the durations
/// of the corners [s], or an empty vector if that fails. Each pass changes all legs simultaneously, so that the
/// reversed path gets the same times.
std::vector<double> fitCorners(Legs& legs, const JointSpeeds& speeds) {
  std::vector<double> corners = cornerTimes(legs, speeds);
  for (int repair = 0; repair < kMostRepairs; ++repair) {
    bool fits = true;
    for (std::size_t k = 0; k < legs.size(); ++k) {
      if (corners[k] + corners[k + 1] <= 2 * legs.times[k] * (1 + 1e-12)) continue;
      legs.times[k] *= kRepair;
      fits = false;
    }
    if (fits) return corners;
    corners = cornerTimes(legs, speeds);
  }
  return {};
}

/// Returns a flow of stop-to-stop moves, for waypoints that have no corners or cannot be passed without stops.
TimedFlow restingFlow(const std::vector<VectorXd>& waypoints, const JointSpeeds& speeds) {
  TimedFlow flow;
  flow.end = waypoints.back();
  for (const TimedMove& move : timePolyline(waypoints, speeds).moves) {
    const VectorXd way = move.to - move.from, still = VectorXd::Zero(way.size());
    const VectorXd peak = move.peak_speed * way;
    const auto add = [&](double duration, const VectorXd& from, const VectorXd& speed, const VectorXd& change) {
      if (duration <= 0) return;
      flow.phases.push_back({flow.duration, duration, from, speed, change / duration});
      flow.duration += duration;
    };
    const VectorXd ramp = 0.5 * move.ramp_time * peak;
    add(move.ramp_time, move.from, still, peak);
    add(move.cruise_time, move.from + ramp, peak, still);
    add(move.ramp_time, move.to - ramp, peak, -peak);
  }
  return flow;
}

bool isCurved(const FlowPhase& phase) {
  const double across =
      phase.speed.squaredNorm() * phase.acceleration.squaredNorm() - std::pow(phase.speed.dot(phase.acceleration), 2);
  return across > 1e-24 * phase.speed.squaredNorm() * phase.acceleration.squaredNorm();
}

}  // namespace

VectorXd FlowPhase::at(double time) const { return from + time * (speed + 0.5 * time * acceleration); }

TimedFlow timeFlow(const std::vector<VectorXd>& waypoints, const JointSpeeds& speeds) {
  assert(!waypoints.empty() && findSpeedProblems(speeds, waypoints.front().size()).empty());
  Legs legs = legsOf(waypoints, speeds);
  if (legs.size() < 2) return restingFlow(waypoints, speeds);
  const std::vector<double> corners = fitCorners(legs, speeds);
  if (corners.empty()) return restingFlow(waypoints, speeds);
  TimedFlow flow;
  flow.end = waypoints.back();
  VectorXd at = waypoints.front();
  const auto add = [&](double duration, const VectorXd& speed, const VectorXd& acceleration) {
    if (duration <= 0) return;
    flow.phases.push_back({flow.duration, duration, at, speed, acceleration});
    at = flow.phases.back().at(duration);
    flow.duration += duration;
  };
  const VectorXd still = VectorXd::Zero(at.size());
  for (std::ptrdiff_t k = 0; k <= static_cast<std::ptrdiff_t>(legs.size()); ++k) {
    const double corner = corners[static_cast<std::size_t>(k)];
    const VectorXd before = legs.speed(k - 1), after = legs.speed(k);
    if (corner > 0) add(corner, before, (after - before) / corner);
    if (k < static_cast<std::ptrdiff_t>(legs.size()))
      add(legs.times[static_cast<std::size_t>(k)] - (corner + corners[static_cast<std::size_t>(k) + 1]) / 2, after,
          still);
  }
  return flow;
}

std::vector<TimedPosture> sampleFlow(const TimedFlow& flow, double max_step) {
  assert(max_step > 0);
  std::vector<TimedPosture> samples;
  if (flow.phases.empty()) return samples;
  samples.push_back({0, 0, flow.phases.front().from});
  for (std::size_t k = 0; k < flow.phases.size(); ++k) {
    const FlowPhase& phase = flow.phases[k];
    const bool is_last = k + 1 == flow.phases.size();
    const int steps =
        isCurved(phase) ? kChords : std::max(1, static_cast<int>(std::ceil(phase.duration / max_step * (1 - 1e-12))));
    for (int s = 1; s < steps; ++s) {
      const double time = phase.duration * s / steps;
      samples.push_back({phase.start + time, static_cast<int>(k), phase.at(time)});
    }
    samples.push_back({is_last ? flow.duration : flow.phases[k + 1].start, static_cast<int>(k),
                       is_last ? flow.end : flow.phases[k + 1].from});
  }
  return samples;
}

std::vector<VectorXd> cornersOf(const TimedFlow& flow) {
  std::vector<VectorXd> corners;
  for (auto& sample : sampleFlow(flow, std::numeric_limits<double>::infinity()))
    corners.push_back(std::move(sample.posture));
  if (corners.empty()) corners.push_back(flow.end);
  return corners;
}

}  // namespace tubeplan::planner
