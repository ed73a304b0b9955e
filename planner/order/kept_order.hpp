// The order of an earlier plan, adapted to a list that changed by a few tubes. Internal to the planning of visits.
#pragma once

#include <vector>

#include "planner/order/route.hpp"

namespace tubeplan::planner {

/// Returns the visits of the route in the order of `tubes_before`, with new tubes inserted at the least cost. `tubes`:
/// one for each visit. Empty if the lists differ by more than `most_changed` of the visits: a new search is then worth
/// its time.
[[nodiscard]] std::vector<int> keptOrder(const Route& route, const std::vector<int>& tubes,
                                         const std::vector<int>& tubes_before, double most_changed = 0.1);

}  // namespace tubeplan::planner
