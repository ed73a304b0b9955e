// Progress on the terminal and Ctrl-C, as the planner asks for them.
#pragma once

#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// One progress line per stage; stops when the user asks.
[[nodiscard]] planner::PlanHooks terminalHooks();

}  // namespace tubeplan::app
