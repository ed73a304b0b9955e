// The proof of a laid-out plan, segment by segment. Internal to the planning of visits.
#pragma once

#include "planner/visit_plan.hpp"

namespace tubeplan::planner {

/// Proves every segment to the accuracy that is reported, in parallel, and fills in margins and what is tightest.
/// `ends` has one entry per segment: what the memory keeps its proof by. False when the hooks asked to stop before the
/// end.
[[nodiscard]] bool proveAll(const ArmClearance& clearance, const VisitPlanOptions& options,
                            const std::vector<MotionEnds>& ends, const PlanHooks& hooks, PlanCache& cache,
                            VisitPlan& plan);

}  // namespace tubeplan::planner
