// Hooks that show the progress of long work on the terminal and stop it on Ctrl-C.
#pragma once

#include "calibration/hooks.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// Returns planner hooks that show one progress line per stage and stop the work on Ctrl-C.
[[nodiscard]] planner::PlanHooks terminalHooks();

/// Returns hooks for fits and diagnoses that show one progress line per stage and stop the work on Ctrl-C.
[[nodiscard]] calibration::WorkHooks terminalWorkHooks();

}  // namespace tubeplan::app
