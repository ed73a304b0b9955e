// Schedule of a campaign's runs: those done, those in progress and those still to come.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "app/studies/monte_carlo/experiment.hpp"

namespace tubeplan::app {

/// Set of run indices, as ordered ranges that neither overlap nor adjoin.
class RunSet {
 public:
  /// Adds runs that are not yet in the set.
  void insert(RunRange runs);

  [[nodiscard]] std::uint64_t size() const;
  [[nodiscard]] const std::vector<RunRange>& ranges() const { return ranges_; }

 private:
  std::vector<RunRange> ranges_;
};

class RunSchedule {
 public:
  /// Divides `total` runs into chunks of at most `chunk` runs; the runs in `done` are not repeated.
  RunSchedule(std::uint64_t total, std::uint64_t chunk, RunSet done = {});

  /// Returns the next chunk for a worker; std::nullopt if all chunks have been given out.
  [[nodiscard]] std::optional<RunRange> next();

  /// Records that a chunk returned by next() is done.
  void finish(RunRange runs) { done_.insert(runs); }

  [[nodiscard]] std::uint64_t total() const { return total_; }
  [[nodiscard]] const RunSet& done() const { return done_; }
  [[nodiscard]] bool isComplete() const { return done_.size() >= total_; }

 private:
  std::uint64_t total_, chunk_;
  RunSet done_;
  std::deque<RunRange> open_;  ///< runs not given out yet
};

/// Returns the chunk size: 1/64 of the runs, from 1 to `largest`. Smaller chunks cause more overhead; with larger ones,
/// workers wait longer for the last chunks.
[[nodiscard]] std::uint64_t chunkFor(std::uint64_t runs, std::uint64_t largest);

}  // namespace tubeplan::app
