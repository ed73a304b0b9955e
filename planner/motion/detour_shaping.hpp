// Detours around obstacles: found through a single posture if possible, and shaped by local search so that the motion
// through the waypoints is as fast as possible.
#pragma once

#include <vector>

#include "planner/motion/motion_planner.hpp"

namespace tubeplan::planner {

using Waypoints = std::vector<Eigen::VectorXd>;

/// Returns the duration of the motion without stops at the waypoints [s]; the problem must have joint speeds.
[[nodiscard]] double flowTime(const Waypoints& waypoints, const MotionProblem& problem);

/// Checks the motion without stops at the waypoints. Returns its smallest proved margin [m] and the tightest posture
/// met; the motion is blocked if any part is not proved free. `checks` is increased by the number of postures checked.
[[nodiscard]] MotionCheckResult checkFlow(const Waypoints& waypoints, const MotionProblem& problem,
                                          const MotionCheckOptions& options, long& checks);

/// Returns the fastest detour that is proved free and passes through one posture near the middle of the straight move;
/// empty if no posture tried gives one.
[[nodiscard]] Waypoints detourByOnePosture(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                                           const MotionProblem& problem, const MotionCheckOptions& options,
                                           long& checks);

/// Moves, removes and adds inner waypoints of a proved motion at random, with decreasing step size. A change is kept if
/// it saves time and the motion is still proved free. The same seed gives the same waypoints.
void quicken(Waypoints& waypoints, const MotionProblem& problem, const MotionPlannerOptions& options, long& checks);

}  // namespace tubeplan::planner
