// Plan as a work list: a table of the tubes to print and tick off. `plan --tubes` accepts it as input.
#pragma once

#include <string>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

inline constexpr const char* kWorkListFile = "worklist.csv";

/// Returns the given work list, unchanged except for columns that are added at the end or, if it has them already,
/// updated: `visit` is the position in the visiting order, and `outcome` the reason why a tube is not visited. `leg`
/// and `sheet` are added if the list lacks them, so that the list is refused for another leg or sheet. `dwell_s` is
/// added if the plan has dwell times. Without a given list, returns leg,sheet,row,column,x_UNIT,y_UNIT,visit,outcome in
/// visiting order, unreachable tubes last.
[[nodiscard]] std::string workListCsv(const PlanOutcome& outcome);

}  // namespace tubeplan::app
