// A straight move in joint space as a function of time, and a polyline of such moves that stops at every waypoint.
//
// All joints share one normalised profile s(t) from 0 to 1 (accelerate, cruise, decelerate), so that they stay on the
// straight line that was proved free. s' is at most min |v_j / dq_j| and s'' at most min |a_j / dq_j|, so that no joint
// exceeds its limits.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planner/timing/joint_metric.hpp"

namespace tubeplan::planner {

struct TimedMove {
  Eigen::VectorXd from;    ///< start posture [rad]
  Eigen::VectorXd to;      ///< end posture [rad]
  double ramp_time = 0;    ///< duration of the acceleration, and of the deceleration [s]; 0 with infinite acceleration
  double cruise_time = 0;  ///< duration at constant speed [s]; 0 in a triangular profile
  double peak_speed = 0;   ///< largest rate s' of the profile [1/s]
  double duration = 0;     ///< 2 ramp_time + cruise_time [s]; 0 if no joint moves
};

/// Returns the fastest profile for the straight line from q0 to q1. Asserts that the limits are usable
/// (findSpeedProblems()).
[[nodiscard]] TimedMove timeMove(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const JointSpeeds& speeds);

/// Returns the progress s in [0, 1] at `time` [s] after the start; clamped outside the move.
[[nodiscard]] double progressAt(const TimedMove& move, double time);

/// Returns the posture at `time` [s] after the start: exactly `from` up to 0 and exactly `to` from the duration on.
[[nodiscard]] Eigen::VectorXd sampleMove(const TimedMove& move, double time);

/// Returns the postures at several times [s] after the start.
[[nodiscard]] std::vector<Eigen::VectorXd> sampleMove(const TimedMove& move, const std::vector<double>& times);

/// Moves end to end, with a stop at every waypoint.
struct TimedPolyline {
  std::vector<TimedMove> moves;     ///< moves between consecutive waypoints: one fewer than there are waypoints
  std::vector<double> start_times;  ///< start of each move [s]
  double duration = 0;              ///< duration of all moves [s]
};

/// Times a polyline through one or more waypoints; a single waypoint gives a polyline without moves.
[[nodiscard]] TimedPolyline timePolyline(const std::vector<Eigen::VectorXd>& waypoints, const JointSpeeds& speeds);

struct TimedPosture {
  double time = 0;  ///< time since the start of the polyline or flow [s]
  int move = 0;     ///< index of the move or phase in progress, or ending at this time
  Eigen::VectorXd posture;
};

/// Returns postures at most `max_step` [s] apart, evenly spaced within each move. Both ends of every move are included
/// exactly and once; a move of zero length adds no posture. Times are strictly increasing. Empty for a polyline without
/// moves.
[[nodiscard]] std::vector<TimedPosture> samplePolyline(const TimedPolyline& polyline, double max_step);

}  // namespace tubeplan::planner
