// A line on the terminal that says how far long work is, how fast it goes and how long it will take.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace tubeplan::app {

/// Writes to standard error, and only where that is a terminal. Not for use from several threads at once.
class Progress {
 public:
  Progress(std::string label, std::size_t total);
  ~Progress();  ///< wipes the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// So many of the total are done. Redraws at most ten times a second.
  void update(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string label_;
  std::size_t total_;
  bool is_shown_;
  Clock::time_point start_, drawn_;
};

/// "planning [#####-----] 30/60  12.1/s  0:02 left" in at most `width` characters; "planning ..." where nobody knows
/// the total (0).
[[nodiscard]] std::string progressLine(const std::string& label, std::size_t done, std::size_t total, double seconds,
                                       int width);

}  // namespace tubeplan::app
