// The straight move in joint space as a function of time, and a polyline of such moves that stops at every waypoint.
//
// All joints share one normalised profile s(t) from 0 to 1 (speed up, cruise, slow down), so that the joints stay on
// the straight line that was proved free. s' is at most min |v_j / dq_j| and s'' at most min |a_j / dq_j|: no joint
// exceeds its limits.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/timing/joint_metric.hpp"

namespace tubeplan::planner {

struct TimedMove {
  Eigen::VectorXd from;    ///< [rad]
  Eigen::VectorXd to;      ///< [rad]
  double ramp_time = 0;    ///< time of speeding up, and of slowing down; 0 with infinite acceleration [s]
  double cruise_time = 0;  ///< 0 in a triangle [s]
  double peak_speed = 0;   ///< greatest s' [1/s]
  double duration = 0;     ///< 2 ramp_time + cruise_time; 0 if nothing moves [s]
};

/// Returns the quickest profile for the straight line from q0 to q1. Asserts that the limits are usable
/// (findSpeedProblems()).
[[nodiscard]] TimedMove timeMove(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const JointSpeeds& speeds);

/// Returns the progress s in [0, 1] at `time` [s] after the start; clamped outside the move.
[[nodiscard]] double progressAt(const TimedMove& move, double time);

/// Returns the posture at `time` [s] after the start: exactly `from` up to 0 and exactly `to` from the duration on.
[[nodiscard]] Eigen::VectorXd sampleMove(const TimedMove& move, double time);

/// Returns the postures at many times [s] after the start.
[[nodiscard]] std::vector<Eigen::VectorXd> sampleMove(const TimedMove& move, const std::vector<double>& times);

/// Moves end to end, with a stop at every waypoint.
struct TimedPolyline {
  std::vector<TimedMove> moves;     ///< waypoints - 1
  std::vector<double> start_times;  ///< start of each move [s]
  double duration = 0;              ///< [s]
};

/// Times a polyline of one waypoint or more; a single one gives a polyline without moves.
[[nodiscard]] TimedPolyline timePolyline(const std::vector<Eigen::VectorXd>& waypoints, const JointSpeeds& speeds);

struct TimedPosture {
  double time = 0;  ///< [s]
  int move = 0;     ///< move that is under way, or that ends here
  Eigen::VectorXd posture;
};

/// Returns postures at most `max_step` [s] apart, evenly within each move. Both ends of every move are among them,
/// exactly and once; a move without length adds none. Times are strictly increasing. Empty for a polyline without
/// moves.
[[nodiscard]] std::vector<TimedPosture> samplePolyline(const TimedPolyline& polyline, double max_step);

}  // namespace tubeplan::planner
