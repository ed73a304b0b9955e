// How long a stop-to-stop motion of several joints lasts. rad (m for a slide), rad/s, rad/s^2, s.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

namespace tubeplan::planner {

/// Limits of each joint, all above zero. An infinite acceleration is a joint that starts and stops at once.
struct JointSpeeds {
  Eigen::VectorXd max_speed;         ///< rad/s
  Eigen::VectorXd max_acceleration;  ///< rad/s^2
};

/// What is wrong with `speeds` for an arm of `joints` joints, one sentence each; empty when usable.
[[nodiscard]] std::vector<std::string> findSpeedProblems(const JointSpeeds& speeds, Eigen::Index joints);

/// The least time [s] in which any motion brings every joint from q0 to q1, from rest to rest: the slowest joint's own
/// triangle or trapezoid. A motion through further postures, curved or not, never takes less.
[[nodiscard]] double moveDuration(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const JointSpeeds& speeds);

/// The least time [s] along the straight line in joint space: all joints share one profile. At least `moveDuration`,
/// and equal to it when one ratio of speed to acceleration holds for all joints. Stopping on the way, wherever, never
/// gains.
[[nodiscard]] double straightMoveDuration(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                                          const JointSpeeds& speeds);

/// Time [s] of one rest-to-rest move of unit length whose greatest speed is 1/cruise_seconds [1/s] and whose greatest
/// acceleration is 1/ramp_seconds2 [1/s^2]. Both zero: no time at all.
[[nodiscard]] inline double unitMoveDuration(double cruise_seconds, double ramp_seconds2) {
  if (ramp_seconds2 > cruise_seconds * cruise_seconds) return 2 * std::sqrt(ramp_seconds2);
  return cruise_seconds > 0 ? cruise_seconds + ramp_seconds2 / cruise_seconds : 0;
}

}  // namespace tubeplan::planner
