// Hooks with which a caller monitors and stops long-running work.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace tubeplan::calibration {

/// Function that returns true to request a stop. Once it has returned true, it must keep doing so. Several threads may
/// call it concurrently. An empty function never requests a stop.
using StopQuestion = std::function<bool()>;

/// Hooks of long-running work. Either may be empty, and neither changes a computed result. The calling thread calls
/// `progress` with the number of steps done in a stage and their total (0 means unknown). If `stop` returns true, the
/// work ends early and its result contains only the status `stopped`.
struct WorkHooks {
  std::function<void(std::string_view stage, std::size_t done, std::size_t total)> progress;
  StopQuestion stop;
};

[[nodiscard]] inline bool shouldStop(const StopQuestion& stop) { return stop && stop(); }

/// Returns hooks for a nested task: the task stops on the same request, but does not report progress.
[[nodiscard]] inline WorkHooks withoutProgress(const WorkHooks& hooks) { return {{}, hooks.stop}; }

/// Exception that unwinds stopped work within this library. The function that was given the hooks catches it.
struct WorkStopped {};

/// Value of the member `reason` in the result of work that was stopped.
inline constexpr const char* kStoppedReason = "stopped on request";

inline void throwIfStopped(const StopQuestion& stop) {
  if (shouldStop(stop)) throw WorkStopped{};
}

/// Returns the result of `work`. If `work` throws WorkStopped, returns an otherwise empty result with the status
/// `stopped`.
template <class Result, class Status, class Work>
[[nodiscard]] Result unlessStopped(Status Result::*status, Status stopped, const Work& work) {
  try {
    return work();
  } catch (const WorkStopped&) {
    Result result;
    result.*status = stopped;
    result.reason = kStoppedReason;
    return result;
  }
}

inline void reportProgress(const WorkHooks& hooks, std::string_view stage, std::size_t done = 0,
                           std::size_t total = 0) {
  throwIfStopped(hooks.stop);
  if (hooks.progress) hooks.progress(stage, done, total);
}

}  // namespace tubeplan::calibration
