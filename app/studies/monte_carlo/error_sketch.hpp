// The distribution of errors in little memory: exact sums and counts by size.
//
// Errors are lengths, taken to whole units of 2^-30 m (0.93 nm). All stored numbers are sums of whole numbers, so that
// sketches merged in any order, in any grouping, are the same to the last bit. Sizes are counted in 64 equal parts of
// each octave (as Tene's HdrHistogram does): a quantile is within 1/64 of the exact one, or one unit.
#pragma once

#include <cstdint>
#include <vector>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

class ErrorSketch {
 public:
  /// Unit of the whole numbers [m].
  static constexpr double kUnit = 1. / (1 << 30);
  /// Largest error [m]; larger ones count as this.
  static constexpr double kLargest = 1 << 13;
  static constexpr int kPartsOfOctave = 64;

  /// Returns an error [m], not negative, in units.
  [[nodiscard]] static std::uint64_t unitsOf(double error);

  void add(std::uint64_t units);
  void merge(const ErrorSketch& other);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double mean() const;   ///< [m]; NaN without errors, as for all below
  [[nodiscard]] double rms() const;    ///< [m]
  [[nodiscard]] double sigma() const;  ///< standard deviation of one error (n - 1) [m]; NaN below two
  [[nodiscard]] double max() const;    ///< [m]

  /// Returns the least error that this share of all does not exceed [m].
  [[nodiscard]] double quantile(double share) const;

  /// A point of the distribution: `count` errors are at most `error` [m].
  struct Point {
    double error;
    std::uint64_t count;
  };
  /// Returns a point at the end of each part with any errors, in order.
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
  std::vector<std::uint64_t> counts_;  ///< counts by part, from first_part_
};

}  // namespace tubeplan::app
