// Proof, segment by segment, that the path of a timed plan is free. Internal to the planning of visits.
#pragma once

#include "planner/plan_context.hpp"

namespace tubeplan::planner {

/// Proves in parallel that every segment of the plan is free, and sets the margins, accurate to `report_accuracy`, and
/// the tightest pairs. `ends` has one entry per segment: the key of its proof in the cache. Returns false if the proof
/// was stopped early.
[[nodiscard]] bool proveAll(const PlanContext& context, const std::vector<MotionEnds>& ends, VisitPlan& plan);

}  // namespace tubeplan::planner
