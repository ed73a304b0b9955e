// How long work reports its progress, and how it is asked to stop.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace tubeplan::calibration {

/// Whether to stop. Once true it must stay so; it may be asked by several threads at once. Empty: never.
using StopQuestion = std::function<bool()>;

/// Told how much of a stage is done (a total of 0: nobody knows), by the thread that called; asked whether to stop. A
/// verb that was stopped says so by its status and gives nothing else. Either may be empty: neither changes a result.
struct WorkHooks {
  std::function<void(std::string_view stage, std::size_t done, std::size_t total)> progress;
  StopQuestion stop;
};

[[nodiscard]] inline bool shouldStop(const StopQuestion& stop) { return stop && stop(); }

/// For work within work: stops as the whole does, and leaves the telling to it.
[[nodiscard]] inline WorkHooks withoutProgress(const WorkHooks& hooks) { return {{}, hooks.stop}; }

/// Unwinds work that was asked to stop, within this library: the verb that was given the hooks catches it.
struct WorkStopped {};

/// Of a status that says so.
inline constexpr const char* kStoppedReason = "stopped on request";

inline void goOn(const StopQuestion& stop) {
  if (shouldStop(stop)) throw WorkStopped{};
}

inline void reportProgress(const WorkHooks& hooks, std::string_view stage, std::size_t done = 0,
                           std::size_t total = 0) {
  goOn(hooks.stop);
  if (hooks.progress) hooks.progress(stage, done, total);
}

}  // namespace tubeplan::calibration
