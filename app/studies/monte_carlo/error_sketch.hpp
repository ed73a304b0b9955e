// Compact representation of a distribution of errors: exact sums and a histogram.
//
// Errors are lengths, rounded to integer multiples of 2^-30 m (0.93 nm). All stored values are sums of integers, so
// that sketches merged in any order and grouping are identical. Each octave of the histogram has 64 equal bins (as in
// Tene's HdrHistogram), so a quantile is within 1/64 of the exact value, or within one unit.
#pragma once

#include <cstdint>
#include <vector>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

class ErrorSketch {
 public:
  /// Unit of the integers [m].
  static constexpr double kUnit = 1. / (1 << 30);
  /// Largest error [m]; larger errors are counted as this value.
  static constexpr double kLargest = 1 << 13;
  static constexpr int kPartsOfOctave = 64;

  /// Returns a non-negative error [m] in units of kUnit, rounded.
  [[nodiscard]] static std::uint64_t unitsOf(double error);

  void add(std::uint64_t units);
  void merge(const ErrorSketch& other);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double mean() const;   ///< mean error [m]; NaN without errors, as are rms() and max()
  [[nodiscard]] double rms() const;    ///< root mean square of the errors [m]
  [[nodiscard]] double sigma() const;  ///< standard deviation of the errors (n - 1) [m]; NaN for fewer than two errors
  [[nodiscard]] double max() const;    ///< largest error [m]

  /// Returns the `share` quantile of the errors [m]; NaN without errors.
  [[nodiscard]] double quantile(double share) const;

  /// A point of the cumulative distribution: `count` errors are at most `error` [m].
  struct Point {
    double error;
    std::uint64_t count;
  };
  /// Returns a point of the cumulative distribution at the upper end of each bin with errors, in ascending order.
  [[nodiscard]] std::vector<Point> distribution() const;

  void put(TallyWords& words) const;
  static ErrorSketch read(WordReader& reader);

  bool operator==(const ErrorSketch&) const = default;

 private:
  [[nodiscard]] static std::uint32_t partOf(std::uint64_t units);
  [[nodiscard]] static std::uint64_t startOf(std::uint32_t part);
  void makeRoom(std::uint32_t part);

  std::uint64_t count_ = 0, max_ = 0;
  WideCount sum_ = 0, squares_ = 0;
  std::uint32_t first_part_ = 0;
  std::vector<std::uint64_t> counts_;  ///< number of errors in each bin, starting with bin first_part_
};

}  // namespace tubeplan::app
