// Plan as a work list: a table to print and tick off, and an input of `plan --tubes`.
#pragma once

#include <string>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

inline constexpr const char* kWorkListFile = "worklist.csv";

/// Returns the work list that named the tubes, byte for byte, with columns added at the end: `visit`, the place in
/// visiting order; `outcome`, the reason if a tube is not visited; if the list lacks them `leg` and `sheet`, by which
/// another leg or sheet refuses it, and `dwell_s`, if the plan has dwell times. Without a list, returns
/// leg,sheet,row,column,x_UNIT,y_UNIT,visit,outcome in visiting order, unreachable tubes last.
[[nodiscard]] std::string workListCsv(const PlanOutcome& outcome);

}  // namespace tubeplan::app
