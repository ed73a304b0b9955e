// Progress reports of long work outside the planner, and an exception that ends the work on a request to stop.
#pragma once

#include <string>
#include <string_view>

#include "calibration/hooks.hpp"

namespace tubeplan::app {

using calibration::WorkHooks;

/// Exception that ends work on a request to stop. Caught once, by the caller that would have used the result.
struct JobStopped {
  std::string kept;  ///< phrase that names the results already written; empty: none
};

inline void requireGoingOn(const WorkHooks& hooks) {
  if (calibration::shouldStop(hooks.stop)) throw JobStopped{};
}

/// Reports the progress of a step such as "fit" or "diagnosis". Throws JobStopped on a request to stop.
inline void beginStep(const WorkHooks& hooks, std::string_view step, std::size_t done = 0, std::size_t total = 0) {
  requireGoingOn(hooks);
  if (hooks.progress) hooks.progress(step, done, total);
}

/// Returns hooks for the stages of a step. They report the step's name before the stage, as in "diagnosis 2:
/// catalogue".
inline WorkHooks within(const WorkHooks& hooks, const std::string& step) {
  if (!hooks.progress) return hooks;
  return {[progress = hooks.progress, step](std::string_view stage, std::size_t done, std::size_t total) {
            progress(step + ": " + std::string(stage), done, total);
          },
          hooks.stop};
}

}  // namespace tubeplan::app
