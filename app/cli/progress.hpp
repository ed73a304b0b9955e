// Terminal line that shows the progress of long work, its rate and the time left.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace tubeplan::app {

struct CommandCaller;

/// Progress line on standard error, shown only if standard error is a terminal. A
/// caller other than the terminal receives the progress through its hooks. Not thread-safe.
class Progress {
 public:
  Progress(std::string label, std::size_t total);
  ~Progress();  ///< Clears the progress line.
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Reports that `done` of the `total` items are complete. Redraws the line at most ten times a second.
  void update(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string label_;
  std::size_t total_;
  const CommandCaller* caller_;
  bool is_shown_;
  Clock::time_point start_, drawn_;
};

/// Returns a line such as "planning [#####-----] 30/60  12.1/s  0:02 left" of at most `width` characters; "planning
/// ..." if `total` is 0 (unknown). `seconds` is the elapsed time.
[[nodiscard]] std::string progressLine(const std::string& label, std::size_t done, std::size_t total, double seconds,
                                       int width);

}  // namespace tubeplan::app
