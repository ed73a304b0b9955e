// Hooks that show the progress of long work on the terminal and stop it on Ctrl-C.
#pragma once

#include "calibration/hooks.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// Returns planner hooks that show one progress line per stage and stop when the user requests it.
[[nodiscard]] planner::PlanHooks terminalHooks();

/// Returns hooks for fits and diagnoses that show one progress line per stage and stop when the user requests it.
[[nodiscard]] calibration::WorkHooks terminalWorkHooks();

}  // namespace tubeplan::app
