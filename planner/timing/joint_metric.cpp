#include "planner/timing/joint_metric.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tubeplan::planner {

std::vector<std::string> findSpeedProblems(const JointSpeeds& speeds, Eigen::Index joints) {
  if (speeds.max_speed.size() != joints || speeds.max_acceleration.size() != joints) {
    return {"speed and acceleration limits must be given for each of the " + std::to_string(joints) + " joints"};
  }
  std::vector<std::string> problems;
  for (Eigen::Index j = 0; j < joints; ++j) {
    const std::string joint = "joint " + std::to_string(j + 1);
    const double speed = speeds.max_speed[j], acceleration = speeds.max_acceleration[j];
    if (!(speed > 0)) problems.push_back(joint + ": the greatest speed must be above zero");
    if (!(acceleration > 0)) problems.push_back(joint + ": the greatest acceleration must be above zero");
    if (std::isinf(speed) && std::isinf(acceleration)) {
      problems.push_back(joint + ": speed and acceleration cannot both be unlimited");
    }
  }
  return problems;
}

double moveDuration(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const JointSpeeds& speeds) {
  assert(q0.size() == q1.size() && q0.size() == speeds.max_speed.size());
  double slowest = 0;
  for (Eigen::Index j = 0; j < q0.size(); ++j) {
    const double distance = std::abs(q1[j] - q0[j]);
    slowest =
        std::max(slowest, unitMoveDuration(distance / speeds.max_speed[j], distance / speeds.max_acceleration[j]));
  }
  return slowest;
}

double straightMoveDuration(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const JointSpeeds& speeds) {
  assert(q0.size() == q1.size() && q0.size() == speeds.max_speed.size());
  double cruise_seconds = 0, ramp_seconds2 = 0;
  for (Eigen::Index j = 0; j < q0.size(); ++j) {
    const double distance = std::abs(q1[j] - q0[j]);
    cruise_seconds = std::max(cruise_seconds, distance / speeds.max_speed[j]);
    ramp_seconds2 = std::max(ramp_seconds2, distance / speeds.max_acceleration[j]);
  }
  return unitMoveDuration(cruise_seconds, ramp_seconds2);
}

}  // namespace tubeplan::planner
