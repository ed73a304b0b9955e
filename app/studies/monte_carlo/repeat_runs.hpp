// Execution of a campaign until it is complete or stopped. Workers on this and other machines receive chunks on demand,
// and their tallies are added as they arrive. The sums do not depend on the distribution of the chunks.
#pragma once

#include <functional>

#include "app/studies/monte_carlo/ranks.hpp"
#include "app/studies/monte_carlo/run_schedule.hpp"

namespace tubeplan::app {

struct RepeatHooks {
  std::function<void(std::uint64_t done)> progress;
  std::function<bool()> stop;
  /// Called when a checkpoint may be written. If `must` is true, the checkpoint must be written, because it is the last
  /// call.
  std::function<void(bool must)> keep;
};

enum class RepeatStatus { kNotRun, kDone, kStopped };

/// Runs the campaign on the first rank, which distributes chunks, works and adds tallies. `ranks` is null without other
/// ranks. All other ranks have stopped working on return.
[[nodiscard]] RepeatStatus repeatRuns(Experiment& experiment, RunSchedule& schedule, int workers,
                                      const RepeatHooks& hooks, Ranks* ranks);

/// Works on chunks on a rank other than the first, until the first rank tells it to end.
void serveRuns(const Experiment& experiment, int workers, Ranks& ranks);

}  // namespace tubeplan::app
