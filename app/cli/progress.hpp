// A line on the terminal with the progress of long work, its speed and the time left.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace tubeplan::app {

/// A progress line on standard error, shown only on a terminal. Not safe from several threads at once.
class Progress {
 public:
  Progress(std::string label, std::size_t total);
  ~Progress();  ///< clears the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Reports that `done` of the total are done. Redraws at most ten times a second.
  void update(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string label_;
  std::size_t total_;
  bool is_shown_;
  Clock::time_point start_, drawn_;
};

/// Returns "planning [#####-----] 30/60  12.1/s  0:02 left" in at most `width` characters; "planning ..." if the total
/// is unknown (0).
[[nodiscard]] std::string progressLine(const std::string& label, std::size_t done, std::size_t total, double seconds,
                                       int width);

}  // namespace tubeplan::app
