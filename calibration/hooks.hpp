// Progress reports of long work, and the request to stop it.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace tubeplan::calibration {

/// Function that returns true to stop work. Once true it must stay so; several threads may call it at once. Empty:
/// never.
using StopQuestion = std::function<bool()>;

/// Hooks of long work. `progress` is called with the part of a stage that is done (a total of 0: unknown), by the
/// calling thread. `stop` is asked whether to stop: the status then says so, and there is no other result. Either may
/// be empty; neither changes a result.
struct WorkHooks {
  std::function<void(std::string_view stage, std::size_t done, std::size_t total)> progress;
  StopQuestion stop;
};

[[nodiscard]] inline bool shouldStop(const StopQuestion& stop) { return stop && stop(); }

/// Returns hooks for work within work, which stops with it and leaves progress to it.
[[nodiscard]] inline WorkHooks withoutProgress(const WorkHooks& hooks) { return {{}, hooks.stop}; }

/// Exception that unwinds work on a request to stop, within this library: the function with the hooks catches it.
struct WorkStopped {};

/// Reason of a status for stopped work.
inline constexpr const char* kStoppedReason = "stopped on request";

inline void goOn(const StopQuestion& stop) {
  if (shouldStop(stop)) throw WorkStopped{};
}

/// Returns what a verb's work gives or, where it was stopped, a result that says so by its status.
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
  goOn(hooks.stop);
  if (hooks.progress) hooks.progress(stage, done, total);
}

}  // namespace tubeplan::calibration
