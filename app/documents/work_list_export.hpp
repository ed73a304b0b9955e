// A plan as a work list: a table to print and tick off, and to hand to `plan --tubes` again.
#pragma once

#include <string>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

inline constexpr const char* kWorkListFile = "worklist.csv";

/// leg,sheet,row,column,x_UNIT,y_UNIT,priority,comment in visiting order, which is the priority; tubes that cannot be
/// reached come last, without one and with the reason. A list for another sheet or leg is refused by its columns.
[[nodiscard]] std::string workListCsv(const PlanOutcome& outcome);

}  // namespace tubeplan::app
