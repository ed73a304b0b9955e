// A plan as a work list: a table to print and tick off, and to hand to `plan --tubes` again.
#pragma once

#include <string>

#include "app/documents/plan_outcome.hpp"

namespace tubeplan::app {

inline constexpr const char* kWorkListFile = "worklist.csv";

/// Returns the work list that named the tubes, byte for byte, with columns behind its own: `visit`, the place in
/// visiting order, `outcome`, why there is none, and, where the list lacks them, `leg` and `sheet`, by which another
/// leg or sheet refuses it, and `dwell_s`, where the plan stays at tubes. Without a list, returns
/// leg,sheet,row,column,x_UNIT,y_UNIT,visit,outcome in visiting order, tubes that cannot be reached last.
[[nodiscard]] std::string workListCsv(const PlanOutcome& outcome);

}  // namespace tubeplan::app
