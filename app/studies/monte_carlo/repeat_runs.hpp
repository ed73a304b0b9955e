// Runs a campaign to its end or to a stop. Chunks are given to workers on demand, on this machine and on others, and
// their tallies are added as they return. The sums do not depend on who ran what.
#pragma once

#include <functional>

#include "app/studies/monte_carlo/ranks.hpp"
#include "app/studies/monte_carlo/run_schedule.hpp"

namespace tubeplan::app {

struct RepeatHooks {
  std::function<void(std::uint64_t done)> progress;
  std::function<bool()> stop;
  std::function<void(bool must)> keep;  ///< called when a checkpoint may be written; `must`: the last one
};

enum class RepeatStatus { kNotRun, kDone, kStopped };

/// Runs the campaign on the first rank, which distributes, works and adds; `ranks` may be null. When it returns, no
/// other rank is at work.
[[nodiscard]] RepeatStatus repeatRuns(Experiment& experiment, RunSchedule& schedule, int workers,
                                      const RepeatHooks& hooks, Ranks* ranks);

/// Runs chunks on any other rank, until it is told to end.
void serveRuns(const Experiment& experiment, int workers, Ranks& ranks);

}  // namespace tubeplan::app
