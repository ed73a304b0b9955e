// A second proof that the arm keeps clear along a written path: the last check of plan_checks.hpp.
#pragma once

#include "planner/verification/plan_checks.hpp"

namespace tubeplan::planner {

using ReportFinding = std::function<void(std::string what)>;

/// Returns true if a joint value [rad or m] is outside the joint's limits by more than rounding errors.
[[nodiscard]] bool isPastLimit(const deflection::Joint<double>& joint, double q);

/// Checks the clearance at the path's rows and everywhere between consecutive rows that are within the joint limits.
/// All joint values must exist and be finite. `find` is called for each fault; `result` receives the smallest margin
/// and the tightest pair.
void checkPathClearance(const Workcell& cell, const StatedPlan& plan, const PlanCheckOptions& options,
                        const PlanHooks& hooks, const ReportFinding& find, PlanCheck& result);

}  // namespace tubeplan::planner
