// The path of a plan as a controller wants it: positions, speeds and accelerations of the joints over time.
#pragma once

#include "planner/visit_plan.hpp"

namespace tubeplan::planner {

struct TrajectoryPoint {
  double time = 0;                                ///< s
  Eigen::VectorXd position, speed, acceleration;  ///< rad, 1/s and 1/s^2 of it (m for a sliding joint)
};

/// Points wherever the acceleration changes: start, end of speeding up, start of slowing down and end of each straight
/// move, both ends of each rounded corner and of each stay. Cubics through positions and speeds are the motion itself;
/// any interpolation that keeps the joints' profiles alike stays on the lines that were proved free. The acceleration
/// is that of the stretch which begins there, none at the end. Times rise strictly, by `least_step` [s] or more.
[[nodiscard]] std::vector<TrajectoryPoint> trajectoryOf(const VisitPlan& plan, const JointSpeeds& speeds,
                                                        double least_step = 1e-6);

}  // namespace tubeplan::planner
