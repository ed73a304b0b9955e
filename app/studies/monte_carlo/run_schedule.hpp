// The runs of a campaign that are done, those at work, and those that come next.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "app/studies/monte_carlo/experiment.hpp"

namespace tubeplan::app {

/// Runs as ordered ranges that neither touch nor overlap.
class RunSet {
 public:
  /// Adds runs, none of which may be in the set.
  void insert(RunRange runs);

  [[nodiscard]] std::uint64_t size() const;
  [[nodiscard]] const std::vector<RunRange>& ranges() const { return ranges_; }

 private:
  std::vector<RunRange> ranges_;
};

class RunSchedule {
 public:
  /// `total` runs in chunks of at most `chunk`; those in `done` are not run again.
  RunSchedule(std::uint64_t total, std::uint64_t chunk, RunSet done = {});

  /// Returns the next chunk for a worker; nothing if all are given.
  [[nodiscard]] std::optional<RunRange> next();

  /// Notes that a given chunk is done.
  void finish(RunRange runs) { done_.insert(runs); }

  [[nodiscard]] std::uint64_t total() const { return total_; }
  [[nodiscard]] const RunSet& done() const { return done_; }
  [[nodiscard]] bool isComplete() const { return done_.size() >= total_; }

 private:
  std::uint64_t total_, chunk_;
  RunSet done_;
  std::deque<RunRange> open_;  ///< chunks that are not given yet
};

/// Returns a chunk size so small that no worker waits long for the last ones, and so large that there are few.
[[nodiscard]] std::uint64_t chunkFor(std::uint64_t runs, std::uint64_t largest);

}  // namespace tubeplan::app
