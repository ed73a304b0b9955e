// Iteration from starts to goals, for any arm. The goals are ranked. First is the position of the tip. Second is the
// smallest angle between tool axis and goal axis that the joints can reach with the position held. Third are the joint
// limits, with the remaining freedom. Internal to the inverse kinematics.
#pragma once

#include <span>
#include <vector>

#include "deflection/inverse/goal_problem.hpp"

namespace tubeplan::deflection {

/// Returns one branch for each start, led to its goal. Several starts are solved side by side, with the same results as
/// one by one. The steps are Newton steps for the position and Gauss-Newton steps for the remaining tilt, shortened
/// while the residual grows.
[[nodiscard]] std::vector<Branch> leadToGoals(GoalProblem& problem, std::span<const ToolGoal> goals,
                                              std::span<const Eigen::VectorXd> starts);

}  // namespace tubeplan::deflection
