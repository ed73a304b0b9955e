// Schedules of legs of which some must not have an arm at the same time.
#pragma once

#include "app/outage/job_schedule.hpp"

namespace tubeplan::app {

/// A schedule as the order in which the legs begin, each as early as the legs before it allow.
struct StartOrder {
  std::vector<ScheduledLeg> legs;  ///< scheduled legs, in order of their start
  double end = 0;                  ///< end of the last leg [s]
  bool is_optimal = false;         ///< true if no order ends earlier
};

/// Returns the order that ends earliest. `lower_bound` [s] is a time before which no schedule ends; the search stops at
/// an order that ends then. For more than 12 legs the result is the better of two orders by priority: the longest legs
/// first, and the legs first whose group has the most work.
///
/// Every schedule can be written as an order of beginnings, and moving each leg to the earliest time that this order
/// allows makes none of them end later, so that the orders contain an optimal schedule. The search cuts an order where
/// the work left for the arms, a group or a leg cannot end before the best known end, and where the same legs were
/// begun with arms and groups free at least as early.
[[nodiscard]] StartOrder bestStartOrder(const std::vector<LegWork>& legs, int arms,
                                        const std::vector<ExclusiveLegs>& exclusive_legs, double lower_bound);

}  // namespace tubeplan::app
