// Lower bound for the remaining tubes of an earlier plan, from the bound of that plan. Internal to the planning of
// visits.
#pragma once

#include "planner/real_order.hpp"

namespace tubeplan::planner {

/// Returns a proved lower bound [s] of every route through the tubes of `choice`. A route through the tubes that are no
/// longer in it, continued by such a route, visits all tubes of the earlier plan, so that both together take no less
/// time than the bound of that plan. NaN if the cache has no such bound, or only a bound for other end
/// postures.
[[nodiscard]] double remainingBound(const PlanContext& context, const VisitChoice& choice);

}  // namespace tubeplan::planner
