// Iteration from start postures to goals, for any arm. It first brings the tip to the goal position. With the position
// held, it makes the angle between tool axis and goal axis as small as possible. With any remaining freedom, it brings
// joints within their limits. Internal to the inverse kinematics.
#pragma once

#include <span>
#include <vector>

#include "deflection/inverse/goal_problem.hpp"

namespace tubeplan::deflection {

/// Returns one branch for each start: the result of the iteration to the goal with the same index. Several starts are
/// solved in parallel lanes, with the same results as one at a time. The steps are Newton steps for the position and
/// Gauss-Newton steps for the remaining tilt, shortened while the residual grows.
[[nodiscard]] std::vector<Branch> leadToGoals(GoalProblem& problem, std::span<const ToolGoal> goals,
                                              std::span<const Eigen::VectorXd> starts);

}  // namespace tubeplan::deflection
