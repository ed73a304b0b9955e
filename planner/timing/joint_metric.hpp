// Duration of a stop-to-stop motion of several joints [rad (m for a prismatic joint), rad/s, rad/s^2, s].
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

namespace tubeplan::planner {

/// Speed and acceleration limits of each joint, all above zero. A joint with infinite acceleration starts and stops
/// instantly.
struct JointSpeeds {
  Eigen::VectorXd max_speed;         ///< maximum speed of each joint [rad/s]
  Eigen::VectorXd max_acceleration;  ///< maximum acceleration of each joint [rad/s^2]
};

/// Returns the problems of `speeds` for an arm of `joints` joints, one sentence each; empty if usable.
[[nodiscard]] std::vector<std::string> findSpeedProblems(const JointSpeeds& speeds, Eigen::Index joints);

/// Returns the shortest time [s] of any rest-to-rest motion of all joints from q0 to q1: the duration of the slowest
/// joint's own triangular or trapezoidal speed profile. A motion through other postures, curved or not, never takes
/// less.
[[nodiscard]] double moveDuration(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const JointSpeeds& speeds);

/// Returns the shortest time [s] along the straight line in joint space, with one speed profile for all joints. It is
/// at least moveDuration(), with equality if all joints have the same ratio of speed to acceleration. Intermediate
/// stops never save time.
[[nodiscard]] double straightMoveDuration(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                                          const JointSpeeds& speeds);

/// Returns the duration [s] of a rest-to-rest move of unit length with maximum speed 1/cruise_seconds [1/s] and maximum
/// acceleration 1/ramp_seconds2 [1/s^2]. If both arguments are zero, the duration is zero.
[[nodiscard]] inline double unitMoveDuration(double cruise_seconds, double ramp_seconds2) {
  if (ramp_seconds2 > cruise_seconds * cruise_seconds) return 2 * std::sqrt(ramp_seconds2);
  return cruise_seconds > 0 ? cruise_seconds + ramp_seconds2 / cruise_seconds : 0;
}

}  // namespace tubeplan::planner
