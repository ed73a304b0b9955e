// The proof of a timed plan, segment by segment. Internal to the planning of visits.
#pragma once

#include "planner/plan_context.hpp"

namespace tubeplan::planner {

/// Proves every segment to the reported accuracy, in parallel, and sets the margins and the tightest pairs. `ends` has
/// one entry per segment: the key of its proof in the cache. Returns false if the proof was stopped early.
[[nodiscard]] bool proveAll(const PlanContext& context, const std::vector<MotionEnds>& ends, VisitPlan& plan);

}  // namespace tubeplan::planner
