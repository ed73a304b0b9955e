// Progress on the terminal and Ctrl-C, as hooks of long work.
#pragma once

#include "calibration/hooks.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// Returns hooks that show one progress line per stage, and stop on the user's request.
[[nodiscard]] planner::PlanHooks terminalHooks();

/// Returns the same hooks for fits and diagnoses.
[[nodiscard]] calibration::WorkHooks terminalWorkHooks();

}  // namespace tubeplan::app
