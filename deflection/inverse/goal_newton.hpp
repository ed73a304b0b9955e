// Goals met by steps, for whatever arm. What holds and what is least has an order: the tip's place; then the tool's
// lean against the goal's axis, as far as the joints can change it with the place held; then, with what is still free,
// the limits of the joints. Internal to the inverse.
#pragma once

#include <span>
#include <vector>

#include "deflection/inverse/goal_problem.hpp"

namespace tubeplan::deflection {

/// One branch for each start, led to its goal, some side by side: each as if it were alone. Newton where the place is
/// concerned, Gauss-Newton for the lean that stays; shortened while it leads away.
[[nodiscard]] std::vector<Branch> leadToGoals(GoalProblem& problem, std::span<const ToolGoal> goals,
                                              std::span<const Eigen::VectorXd> starts);

}  // namespace tubeplan::deflection
