// Ways round an obstacle made quick: found through one posture where that will do, and shaped so that the arm flows
// through its waypoints in the least time that local search finds.
#pragma once

#include <vector>

#include "planner/motion/motion_planner.hpp"

namespace tubeplan::planner {

using Waypoints = std::vector<Eigen::VectorXd>;

/// Time [s] without rest at the waypoints; the problem must have speeds.
[[nodiscard]] double flowTime(const Waypoints& waypoints, const MotionProblem& problem);

/// Least proved margin along the flow [m] and the tightest posture met; blocked where any part is not proved free.
[[nodiscard]] MotionCheckResult checkFlow(const Waypoints& waypoints, const MotionProblem& problem,
                                          const MotionCheckOptions& options, long& checks);

/// The quickest proved way through one posture beside the middle of the straight move; empty where none of those tried
/// is free.
[[nodiscard]] Waypoints detourByOnePosture(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                                           const MotionProblem& problem, const MotionCheckOptions& options,
                                           long& checks);

/// Moves, drops and adds inner waypoints of a proved flow by chance, ever less, where that saves time and the flow
/// stays proved. Same seed, same flow.
void quicken(Waypoints& waypoints, const MotionProblem& problem, const MotionPlannerOptions& options, long& checks);

}  // namespace tubeplan::planner
