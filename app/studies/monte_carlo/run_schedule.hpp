// Which runs of a campaign are done, which are with a worker, and which come next.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "app/studies/monte_carlo/experiment.hpp"

namespace tubeplan::app {

/// Runs as ranges that neither touch nor overlap, in order.
class RunSet {
 public:
  /// None of them may be in it.
  void insert(RunRange runs);

  [[nodiscard]] std::uint64_t size() const;
  [[nodiscard]] const std::vector<RunRange>& ranges() const { return ranges_; }

 private:
  std::vector<RunRange> ranges_;
};

class RunSchedule {
 public:
  /// `total` runs in chunks of at most `chunk`; those `done` are not asked again.
  RunSchedule(std::uint64_t total, std::uint64_t chunk, RunSet done = {});

  /// The next chunk to give to a worker; nothing where all are given.
  [[nodiscard]] std::optional<RunRange> next();

  /// A chunk that was given came back with its tally.
  void finish(RunRange runs) { done_.insert(runs); }

  [[nodiscard]] std::uint64_t total() const { return total_; }
  [[nodiscard]] const RunSet& done() const { return done_; }
  [[nodiscard]] bool isComplete() const { return done_.size() >= total_; }

 private:
  std::uint64_t total_, chunk_;
  RunSet done_;
  std::deque<RunRange> open_;  ///< not given yet
};

/// Chunks small enough that the last of them keep no worker waiting long, and large enough that they are few.
[[nodiscard]] std::uint64_t chunkFor(std::uint64_t runs, std::uint64_t largest);

}  // namespace tubeplan::app
