// The order of visits where some must come before others: zone after zone, each begun where the one before ended.
// Internal to the planning of visits.
#pragma once

#include <vector>

#include "planner/order/visit_order.hpp"

namespace tubeplan::planner {

/// As `orderVisits`; `zones` has one number for each visit, from 0 and without gaps. Each zone is searched on its own,
/// so the order is the best of its zones, not of all; the bound is one for every order that keeps to the zones.
[[nodiscard]] VisitOrder orderByZones(const Route& route, const std::vector<int>& zones,
                                      const VisitOrderOptions& options);

/// A proved lower bound [s] of every route that keeps to the zones: the sum of the zones' own bounds and of the
/// quickest ways from each to the next.
[[nodiscard]] double zonedBound(const Route& route, const std::vector<int>& zones, const OneTreeOptions& options = {});

/// Row after row within each zone, as practice would: travel time [s] with the best branches.
[[nodiscard]] double rowByRowTime(const Route& route, const std::vector<int>& zones, const std::vector<int>& rows,
                                  const std::vector<int>& columns);

}  // namespace tubeplan::planner
