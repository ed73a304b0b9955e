#include "planner/timing/trapezoid_timing.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tubeplan::planner {

TimedMove timeMove(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const JointSpeeds& speeds) {
  assert(q0.size() == q1.size() && findSpeedProblems(speeds, q0.size()).empty());
  TimedMove move;
  move.from = q0;
  move.to = q1;
  const Eigen::ArrayXd distance = (q1 - q0).array().abs();
  if (!(distance > 0).any()) return move;
  const double cruise_seconds = (distance / speeds.max_speed.array()).maxCoeff();        // 1 / largest s' [s]
  const double ramp_seconds2 = (distance / speeds.max_acceleration.array()).maxCoeff();  // 1 / largest s'' [s^2]
  const bool triangle = ramp_seconds2 > cruise_seconds * cruise_seconds;
  move.ramp_time = triangle ? std::sqrt(ramp_seconds2) : ramp_seconds2 / cruise_seconds;
  move.cruise_time = triangle ? 0 : std::max(0.0, cruise_seconds - move.ramp_time);
  move.peak_speed = 1 / (move.ramp_time + move.cruise_time);
  move.duration = 2 * move.ramp_time + move.cruise_time;
  return move;
}

double progressAt(const TimedMove& move, double time) {
  if (time <= 0) return 0;
  if (time >= move.duration) return 1;
  const double remaining = move.duration - time;
  if (time < move.ramp_time) return 0.5 * move.peak_speed * time * time / move.ramp_time;
  if (remaining < move.ramp_time) return 1 - 0.5 * move.peak_speed * remaining * remaining / move.ramp_time;
  return move.peak_speed * (time - 0.5 * move.ramp_time);
}

Eigen::VectorXd sampleMove(const TimedMove& move, double time) {
  if (time <= 0) return move.from;
  if (time >= move.duration) return move.to;
  return move.from + progressAt(move, time) * (move.to - move.from);
}

std::vector<Eigen::VectorXd> sampleMove(const TimedMove& move, const std::vector<double>& times) {
  std::vector<Eigen::VectorXd> postures;
  postures.reserve(times.size());
  for (const double time : times) postures.push_back(sampleMove(move, time));
  return postures;
}

TimedPolyline timePolyline(const std::vector<Eigen::VectorXd>& waypoints, const JointSpeeds& speeds) {
  assert(!waypoints.empty());
  TimedPolyline polyline;
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    polyline.start_times.push_back(polyline.duration);
    polyline.moves.push_back(timeMove(waypoints[i - 1], waypoints[i], speeds));
    polyline.duration += polyline.moves.back().duration;
  }
  return polyline;
}

std::vector<TimedPosture> samplePolyline(const TimedPolyline& polyline, double max_step) {
  assert(max_step > 0);
  std::vector<TimedPosture> samples;
  if (polyline.moves.empty()) return samples;
  samples.push_back({0, 0, polyline.moves.front().from});
  for (std::size_t m = 0; m < polyline.moves.size(); ++m) {
    const TimedMove& move = polyline.moves[m];
    if (move.duration <= 0) continue;
    const int steps = std::max(1, static_cast<int>(std::ceil(move.duration / max_step * (1 - 1e-12))));
    for (int k = 1; k <= steps; ++k) {
      const double time = k == steps ? move.duration : move.duration * k / steps;
      samples.push_back({polyline.start_times[m] + time, static_cast<int>(m), sampleMove(move, time)});
    }
  }
  return samples;
}

}  // namespace tubeplan::planner
