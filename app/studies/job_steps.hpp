// Progress reports of long computations outside the planner, and the exception that aborts one when a stop is
// requested.
#pragma once

#include <string>
#include <string_view>

#include "calibration/hooks.hpp"

namespace tubeplan::app {

using calibration::WorkHooks;

/// Exception that aborts a computation when a stop is requested. Only the caller that would have used the result
/// catches it.
struct JobStopped {
  std::string kept;  ///< phrase that names the results already written; empty if none
};

inline void throwIfJobStopped(const WorkHooks& hooks) {
  if (calibration::shouldStop(hooks.stop)) throw JobStopped{};
}

/// Reports the progress of a step such as "fit" or "diagnosis". Throws JobStopped if a stop is requested.
inline void beginStep(const WorkHooks& hooks, std::string_view step, std::size_t done = 0, std::size_t total = 0) {
  throwIfJobStopped(hooks);
  if (hooks.progress) hooks.progress(step, done, total);
}

/// Returns hooks that report the stages of a step with the step's name as a prefix, as in "diagnosis 2: catalogue".
inline WorkHooks within(const WorkHooks& hooks, const std::string& step) {
  if (!hooks.progress) return hooks;
  return {[progress = hooks.progress, step](std::string_view stage, std::size_t done, std::size_t total) {
            progress(step + ": " + std::string(stage), done, total);
          },
          hooks.stop};
}

}  // namespace tubeplan::app
