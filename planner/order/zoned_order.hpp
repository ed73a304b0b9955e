// The order of visits with zones: one zone after another, each starting where the previous zone ended. Internal to the
// planning of visits.
#pragma once

#include <vector>

#include "planner/order/visit_order.hpp"

namespace tubeplan::planner {

/// Orders the visits like orderVisits(); `zones` has the zone of each visit, from 0 and without gaps. Each zone is
/// searched separately, so the order is optimised within each zone, not over all zones together. The bound holds for
/// every order that completes one zone before the next.
[[nodiscard]] VisitOrder orderByZones(const Route& route, const std::vector<int>& zones,
                                      const VisitOrderOptions& options);

/// Returns a proved lower bound [s] on the time of every route that completes one zone before the next: the bounds of
/// all zones plus the quickest moves between consecutive zones.
[[nodiscard]] double zonedBound(const Route& route, const std::vector<int>& zones, const OneTreeOptions& options = {});

/// Returns the travel time [s] of the usual order, row after row within each zone, with the best branches; NaN if a
/// list does not have one value for each visit.
[[nodiscard]] double rowByRowTime(const Route& route, const std::vector<int>& zones, const std::vector<int>& rows,
                                  const std::vector<int>& columns);

}  // namespace tubeplan::planner
