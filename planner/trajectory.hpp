// The path of a plan in the form for a controller: positions, speeds and accelerations of the joints over time.
#pragma once

#include "planner/visit_plan.hpp"

namespace tubeplan::planner {

struct TrajectoryPoint {
  double time = 0;                                ///< [s]
  Eigen::VectorXd position, speed, acceleration;  ///< rad, rad/s, rad/s^2 (m for a sliding joint)
};

/// Returns points wherever the acceleration changes: start, end of speeding up, start of slowing down and end of each
/// straight move, both ends of each rounded corner and of each stay. Cubics through positions and speeds are the motion
/// itself; any interpolation with the same profile for all joints stays on the lines that were proved free. The
/// acceleration is that of the stretch that begins there, zero at the end. Times are strictly increasing, by
/// `least_step` [s] or more.
[[nodiscard]] std::vector<TrajectoryPoint> trajectoryOf(const VisitPlan& plan, const JointSpeeds& speeds,
                                                        double least_step = 1e-6);

}  // namespace tubeplan::planner
