// Runs a campaign to its end or to a stop: chunks are handed out as workers want them, on this machine and on others,
// and their tallies are added as they come back. The sums do not depend on who ran what.
#pragma once

#include <functional>

#include "app/studies/monte_carlo/ranks.hpp"
#include "app/studies/monte_carlo/run_schedule.hpp"

namespace tubeplan::app {

struct RepeatHooks {
  std::function<void(std::uint64_t done)> progress;
  std::function<bool()> stop;
  std::function<void(bool must)> keep;  ///< a time to write a checkpoint; `must`: the last one
};

enum class RepeatStatus { kNotRun, kDone, kStopped };

/// The one that hands out, works and adds; `ranks` may be null. When it returns, no other rank is at work.
[[nodiscard]] RepeatStatus repeatRuns(Experiment& experiment, RunSchedule& schedule, int workers,
                                      const RepeatHooks& hooks, Ranks* ranks);

/// Every other rank: works until it is told to end.
void serveRuns(const Experiment& experiment, int workers, Ranks& ranks);

}  // namespace tubeplan::app
