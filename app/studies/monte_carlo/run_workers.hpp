// The threads that run a campaign's chunks on this machine (oneTBB).
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

/// How many workers suit this process: the cores it may use, shared with `others` of its kind on this machine.
[[nodiscard]] int usualWorkers(int others = 1);

class RunWorkers {
 public:
  /// `experiment` must outlive this.
  RunWorkers(const Experiment& experiment, int workers);
  /// Chunks that were not begun are forgotten, those under way are broken off.
  ~RunWorkers();
  RunWorkers(const RunWorkers&) = delete;
  RunWorkers& operator=(const RunWorkers&) = delete;

  /// How many more chunks it takes for no worker to wait.
  [[nodiscard]] int wanted() const;
  void give(RunRange runs);

  struct Result {
    RunRange runs;
    TallyWords tally;
  };
  /// A chunk that is done; waits so long for one. Throws what a run has thrown.
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
  std::exception_ptr failure_;  ///< the first of a run
  int under_way_ = 0;
  bool is_closed_ = false;
  std::atomic<bool> is_broken_off_ = false;
  oneapi::tbb::global_control control_;
  oneapi::tbb::task_arena arena_;
  oneapi::tbb::task_group group_;
};

}  // namespace tubeplan::app
