// Iteration from starts to goals, for any arm. The goals are ranked: the tip's place; then the least angle between the
// tool and the goal's axis, as far as the joints can change it with the place held; then, with the remaining freedom,
// the limits of the joints. Internal to the inverse.
#pragma once

#include <span>
#include <vector>

#include "deflection/inverse/goal_problem.hpp"

namespace tubeplan::deflection {

/// Returns one branch for each start, led to its goal. Some are solved side by side, with the same result as alone. The
/// steps are Newton's for the place and Gauss-Newton's for the remaining tilt, shortened while the residual grows.
[[nodiscard]] std::vector<Branch> leadToGoals(GoalProblem& problem, std::span<const ToolGoal> goals,
                                              std::span<const Eigen::VectorXd> starts);

}  // namespace tubeplan::deflection
