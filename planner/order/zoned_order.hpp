// The order of visits with zones: one zone after another, each starting where the one before ended. Internal to the
// planning of visits.
#pragma once

#include <vector>

#include "planner/order/visit_order.hpp"

namespace tubeplan::planner {

/// Orders the visits like orderVisits(); `zones` has one number for each visit, from 0 and without gaps. Each zone is
/// searched on its own, so the order is the best of its zones, not of all. The bound holds for every order that keeps
/// to the zones.
[[nodiscard]] VisitOrder orderByZones(const Route& route, const std::vector<int>& zones,
                                      const VisitOrderOptions& options);

/// Returns a proved lower bound [s] of every route that keeps to the zones: the sum of the zones' own bounds and of the
/// quickest moves from each to the next.
[[nodiscard]] double zonedBound(const Route& route, const std::vector<int>& zones, const OneTreeOptions& options = {});

/// Returns the travel time [s] of the usual order, row after row within each zone, with the best branches.
[[nodiscard]] double rowByRowTime(const Route& route, const std::vector<int>& zones, const std::vector<int>& rows,
                                  const std::vector<int>& columns);

}  // namespace tubeplan::planner
