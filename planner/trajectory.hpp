// The path of a plan in a form for controllers: positions, speeds and accelerations of the joints over time.
#pragma once

#include "planner/visit_plan.hpp"

namespace tubeplan::planner {

struct TrajectoryPoint {
  double time = 0;  ///< time since the start of the path [s]
  /// Joint values [rad], speeds [rad/s] and accelerations [rad/s^2] (m for a prismatic joint).
  Eigen::VectorXd position, speed, acceleration;
};

/// Returns points wherever the acceleration changes: at the start, end of acceleration, start of deceleration and end
/// of each straight move, and at both ends of each rounded corner and of each dwell time. Cubic polynomials through
/// positions and speeds are the motion itself; any interpolation with the same profile for all joints stays on the
/// lines that were proved free. Each point has the acceleration of the motion that begins there, zero at the end. Times
/// are strictly increasing, by `least_step` [s] or more.
[[nodiscard]] std::vector<TrajectoryPoint> trajectoryOf(const VisitPlan& plan, const JointSpeeds& speeds,
                                                        double least_step = 1e-6);

}  // namespace tubeplan::planner
