// Hooks of long work that Python calls: progress to a Python function, and a stop by Ctrl-C or by an exception of that
// function.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "calibration/hooks.hpp"

namespace tubeplan::app {

/// Runs `work` without Python's global interpreter lock, so that other Python threads can run.
template <class Work>
auto withoutLock(Work&& work) {
  const pybind11::gil_scoped_release released;
  return work();
}

/// Exception of Python that stopped the work: KeyboardInterrupt, or that of the progress function. Created and
/// destroyed by a thread that holds the lock.
class __attribute__((visibility("hidden"))) PythonHooks {
 public:
  /// `progress` is called with stage, done and total; if it is None, no progress is reported.
  explicit PythonHooks(pybind11::object progress) : progress_(std::move(progress)) {}

  /// Returns the hooks, which must not outlive this object.
  [[nodiscard]] calibration::WorkHooks hooks() {
    calibration::WorkHooks hooks;
    if (!progress_.is_none())
      hooks.progress = [this](std::string_view stage, std::size_t done, std::size_t total) {
        report(stage, done, total);
      };
    hooks.stop = [this] { return shouldStop(); };
    return hooks;
  }

  [[nodiscard]] const std::optional<pybind11::error_already_set>& error() const { return error_; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kPollInterval{50}, kReportInterval{100};

  /// Polls Python's signals at most every 50 ms, because this acquires the lock. Only the calling thread polls.
  bool shouldStop() {
    if (is_stopped_ || std::this_thread::get_id() != caller_) return is_stopped_;
    if (Clock::now() - polled_ < kPollInterval) return false;
    const pybind11::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) keepError();
    polled_ = Clock::now();
    return is_stopped_;
  }

  /// Reports the start and the end of every stage, and intermediate progress at most ten times a second.
  void report(std::string_view stage, std::size_t done, std::size_t total) {
    const auto now = Clock::now();
    if (is_stopped_ || (stage == stage_ && now - reported_ < kReportInterval && (total == 0 || done < total))) return;
    stage_ = stage;
    reported_ = now;
    const pybind11::gil_scoped_acquire lock;
    try {
      progress_(stage_, done, total);
    } catch (pybind11::error_already_set& error) {
      error_.emplace(error);
      is_stopped_ = true;
    }
  }

  void keepError() {
    error_.emplace();
    is_stopped_ = true;
  }

  pybind11::object progress_;
  std::optional<pybind11::error_already_set> error_;
  std::atomic<bool> is_stopped_ = false;
  std::thread::id caller_ = std::this_thread::get_id();
  Clock::time_point polled_, reported_;
  std::string stage_;
};

}  // namespace tubeplan::app
