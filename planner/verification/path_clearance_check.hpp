// Proves again that the arm keeps clear along a written path: the last of the checks of plan_checks.hpp.
#pragma once

#include "planner/verification/plan_checks.hpp"

namespace tubeplan::planner {

using TellFinding = std::function<void(std::string what)>;

/// Past it by more than rounding. [rad or m]
[[nodiscard]] bool isPastLimit(const deflection::Joint<double>& joint, double q);

/// At the path's rows and everywhere between those within the joints' limits. All joint values must be there, and
/// finite. `find` is given what is wrong; `result` gets the least margin and the tightest pair.
void checkPathClearance(const Workcell& cell, const StatedPlan& plan, const PlanCheckOptions& options,
                        const PlanHooks& hooks, const TellFinding& find, PlanCheck& result);

}  // namespace tubeplan::planner
