// The straight move in joint space as a function of time, and a polyline of such moves that rests at every waypoint.
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
  Eigen::VectorXd from;    ///< rad
  Eigen::VectorXd to;      ///< rad
  double ramp_time = 0;    ///< s, each of speeding up and slowing down; 0 with infinite acceleration
  double cruise_time = 0;  ///< s, 0 in a triangle
  double peak_speed = 0;   ///< 1/s, greatest s'
  double duration = 0;     ///< s, 2 ramp_time + cruise_time; 0 when nothing moves
};

/// The quickest profile for the straight line from q0 to q1. Asserts that the limits are usable (`findSpeedProblems`).
[[nodiscard]] TimedMove timeMove(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const JointSpeeds& speeds);

/// Progress s in [0, 1] at `time` [s] after the start; clamped outside the move.
[[nodiscard]] double progressAt(const TimedMove& move, double time);

/// Posture at `time` [s] after the start: exactly `from` up to 0 and exactly `to` from the duration on.
[[nodiscard]] Eigen::VectorXd sampleMove(const TimedMove& move, double time);

/// The same for many times.
[[nodiscard]] std::vector<Eigen::VectorXd> sampleMove(const TimedMove& move, const std::vector<double>& times);

/// Moves end to end; the arm rests at every waypoint.
struct TimedPolyline {
  std::vector<TimedMove> moves;     ///< waypoints - 1
  std::vector<double> start_times;  ///< s, one for each move
  double duration = 0;              ///< s
};

/// At least one waypoint; a single one is a polyline without moves.
[[nodiscard]] TimedPolyline timePolyline(const std::vector<Eigen::VectorXd>& waypoints, const JointSpeeds& speeds);

struct TimedPosture {
  double time = 0;  ///< s
  int move = 0;     ///< the move that is under way, or that ends here
  Eigen::VectorXd posture;
};

/// Postures at most `max_step` [s] apart, evenly within each move. Both ends of every move are among them, exactly and
/// once; a move without length adds none. Times rise strictly. Empty for a polyline without moves.
[[nodiscard]] std::vector<TimedPosture> samplePolyline(const TimedPolyline& polyline, double max_step);

}  // namespace tubeplan::planner
