// The order of an earlier plan carried over to a list that changed by a few tubes. Internal to the planning of visits.
#pragma once

#include <vector>

#include "planner/order/route.hpp"

namespace tubeplan::planner {

/// Visits of the route in the order of `tubes_before`, with the tubes that were not in it put in where they cost least
/// time. `tubes`: one for each visit. Empty where the lists differ by more than `most_changed` of the visits: then an
/// order found anew is worth its time.
[[nodiscard]] std::vector<int> keptOrder(const Route& route, const std::vector<int>& tubes,
                                         const std::vector<int>& tubes_before, double most_changed = 0.1);

}  // namespace tubeplan::planner
