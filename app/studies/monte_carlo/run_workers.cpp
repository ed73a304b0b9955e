#include "app/studies/monte_carlo/run_workers.hpp"

#include <oneapi/tbb/info.h>
#include <unistd.h>

#include <algorithm>

namespace tubeplan::app {

int usualWorkers(int others) {
  const int allowed = oneapi::tbb::info::default_concurrency();
  const auto cores = static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN));
  return std::max(1, std::min(allowed, cores / std::max(1, others)));
}

// The distributing thread stays outside the arena, so that it never executes a run.
RunWorkers::RunWorkers(const Experiment& experiment, int workers)
    : experiment_(experiment),
      workers_(workers),
      control_(oneapi::tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(workers) + 1),
      arena_(workers, 0) {
  try {
    for (int k = 0; k < workers_; ++k) arena_.enqueue(group_.defer([this] { workOrFail(); }));
  } catch (...) {
    close();
    throw;
  }
}

RunWorkers::~RunWorkers() { close(); }

void RunWorkers::close() {
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    is_broken_off_ = true;
    waiting_.clear();
  }
  given_.notify_all();
  group_.wait();
}

int RunWorkers::wanted() const {
  const std::lock_guard lock(mutex_);
  return std::max(0, 2 * workers_ - under_way_ - static_cast<int>(waiting_.size()));
}

void RunWorkers::give(RunRange runs) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(runs);
  }
  given_.notify_one();
}

std::optional<RunWorkers::Result> RunWorkers::take(std::chrono::microseconds wait) {
  std::unique_lock lock(mutex_);
  if (!done_.wait_for(lock, wait, [this] { return failure_ || !results_.empty(); })) return std::nullopt;
  if (failure_) std::rethrow_exception(failure_);
  Result result = std::move(results_.front());
  results_.pop_front();
  return result;
}

// Works on chunks and stores an exception for take(). The task group would report the exception only at its end, while
// the caller would wait for results.
void RunWorkers::workOrFail() noexcept {
  try {
    work();
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    done_.notify_one();
  }
}

void RunWorkers::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    given_.wait(lock, [this] { return is_closed_ || !waiting_.empty(); });
    if (is_closed_) return;
    const RunRange runs = waiting_.front();
    waiting_.pop_front();
    ++under_way_;
    lock.unlock();
    // A worker that waits in a parallel loop within a run must not take over another worker's task.
    auto tally = oneapi::tbb::this_task_arena::isolate(
        [&] { return experiment_.run(runs, [this] { return is_broken_off_.load(); }); });
    lock.lock();
    --under_way_;
    if (!tally) continue;
    results_.push_back({runs, std::move(*tally)});
    done_.notify_one();
  }
}

}  // namespace tubeplan::app
