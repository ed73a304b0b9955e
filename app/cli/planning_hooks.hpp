// Progress on the terminal and Ctrl-C, as long work asks for them.
#pragma once

#include "calibration/hooks.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// One progress line per stage; stops when the user asks.
[[nodiscard]] planner::PlanHooks terminalHooks();

/// The same for fits and diagnoses.
[[nodiscard]] calibration::WorkHooks terminalWorkHooks();

}  // namespace tubeplan::app
