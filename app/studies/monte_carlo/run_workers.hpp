// Threads that run a campaign's chunks on this machine (oneTBB).
#pragma once

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>

#include "app/studies/monte_carlo/experiment.hpp"

namespace tubeplan::app {

/// Returns the default number of workers of this process: the number of cores that it may use, but no more than the
/// machine's cores divided by the number of processes (`others`) that share it.
[[nodiscard]] int usualWorkers(int others = 1);

class RunWorkers {
 public:
  /// Starts the workers; `experiment` must outlive this object.
  RunWorkers(const Experiment& experiment, int workers);
  /// Discards chunks that have not begun and stops those in progress.
  ~RunWorkers();
  RunWorkers(const RunWorkers&) = delete;
  RunWorkers& operator=(const RunWorkers&) = delete;

  /// Returns the number of further chunks needed to keep all workers busy.
  [[nodiscard]] int wanted() const;
  void give(RunRange runs);

  struct Result {
    RunRange runs;
    TallyWords tally;
  };
  /// Returns a finished chunk; std::nullopt if none is finished within `wait`. Throws the exception of a run that
  /// failed.
  [[nodiscard]] std::optional<Result> take(std::chrono::microseconds wait);

 private:
  void work();
  void workOrFail() noexcept;
  void close();

  const Experiment& experiment_;
  int workers_;
  mutable std::mutex mutex_;
  std::condition_variable given_, done_;
  std::deque<RunRange> waiting_;
  std::deque<Result> results_;
  std::exception_ptr failure_;  ///< exception of the first run that failed; null if none
  int under_way_ = 0;
  bool is_closed_ = false;
  std::atomic<bool> is_broken_off_ = false;
  oneapi::tbb::global_control control_;
  oneapi::tbb::task_arena arena_;
  oneapi::tbb::task_group group_;
};

}  // namespace tubeplan::app
