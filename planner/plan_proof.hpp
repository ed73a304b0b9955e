// The proof of a laid-out plan, segment by segment. Internal to the planning of visits.
#pragma once

#include "planner/plan_context.hpp"

namespace tubeplan::planner {

/// Proves every segment to the accuracy that is reported, in parallel, and fills in margins and what is tightest.
/// `ends` has one entry per segment: what the memory keeps its proof by. False where it was stopped before the end.
[[nodiscard]] bool proveAll(const PlanContext& context, const std::vector<MotionEnds>& ends, VisitPlan& plan);

}  // namespace tubeplan::planner
