// Optimisation of detours round an obstacle: found through one posture if possible, and shaped so that the arm flows
// through its waypoints in the least time that local search finds.
#pragma once

#include <vector>

#include "planner/motion/motion_planner.hpp"

namespace tubeplan::planner {

using Waypoints = std::vector<Eigen::VectorXd>;

/// Returns the time [s] without stops at the waypoints; the problem must have speeds.
[[nodiscard]] double flowTime(const Waypoints& waypoints, const MotionProblem& problem);

/// Checks the flow. Returns the least proved margin along it [m] and the tightest posture met; blocked if any part is
/// not proved free.
[[nodiscard]] MotionCheckResult checkFlow(const Waypoints& waypoints, const MotionProblem& problem,
                                          const MotionCheckOptions& options, long& checks);

/// Returns the quickest proved detour through one posture beside the middle of the straight move; empty if none of
/// those tried is free.
[[nodiscard]] Waypoints detourByOnePosture(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
                                           const MotionProblem& problem, const MotionCheckOptions& options,
                                           long& checks);

/// Moves, removes and adds inner waypoints of a proved flow at random, in decreasing steps, if that saves time and the
/// flow stays proved. The same seed gives the same flow.
void quicken(Waypoints& waypoints, const MotionProblem& problem, const MotionPlannerOptions& options, long& checks);

}  // namespace tubeplan::planner
