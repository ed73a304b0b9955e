// Progress reports of long work outside the planner, and its end on a request to stop.
#pragma once

#include <string>
#include <string_view>

#include "calibration/hooks.hpp"

namespace tubeplan::app {

using calibration::WorkHooks;

/// Exception of work that ends because it was asked to stop; caught once, where its outcome would have been used.
struct JobStopped {
  std::string kept;  ///< results that were written before, in words; empty: nothing
};

inline void requireGoingOn(const WorkHooks& hooks) {
  if (calibration::shouldStop(hooks.stop)) throw JobStopped{};
}

/// Reports the progress of a step ("fit", "diagnosis"). Throws JobStopped.
inline void beginStep(const WorkHooks& hooks, std::string_view step, std::size_t done = 0, std::size_t total = 0) {
  requireGoingOn(hooks);
  if (hooks.progress) hooks.progress(step, done, total);
}

/// Returns hooks for the parts of a step, which report their progress after its name: "diagnosis 2: catalogue".
inline WorkHooks within(const WorkHooks& hooks, const std::string& step) {
  if (!hooks.progress) return hooks;
  return {[progress = hooks.progress, step](std::string_view stage, std::size_t done, std::size_t total) {
            progress(step + ": " + std::string(stage), done, total);
          },
          hooks.stop};
}

}  // namespace tubeplan::app
