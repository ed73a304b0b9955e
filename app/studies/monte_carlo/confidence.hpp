// Confidence intervals of results from random runs.
#pragma once

#include <cstdint>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

/// Half-width of a two-sided 95 % interval, in standard deviations.
inline constexpr double kTwoSided95 = 1.959963984540054;

/// A probability with its 95 % confidence interval.
struct Probability {
  double value, low, high;
};

/// Returns Wilson's score interval (E. B. Wilson, J. Am. Stat. Assoc. 22, 1927) for `count` successes among `of`
/// independent cases; {NaN, 0, 1} if `of` is 0. The arguments need not be integers: `of` may be an effective number of
/// cases.
[[nodiscard]] Probability wilsonInterval(double count, double of);

/// Sums, over independent runs, of a quantity with several dependent cases in each run. The sums give the mean over all
/// cases and its standard error by the ratio estimator (Cochran, Sampling Techniques, 1977, section 6.4). All sums are
/// integers, so that sums merged in any order are identical.
class RunSums {
 public:
  /// Adds one run: the `sum` of the quantity over the run's `count` cases.
  void add(std::uint64_t sum, std::uint64_t count);
  void merge(const RunSums& other);

  [[nodiscard]] std::uint64_t runs() const { return runs_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double mean() const;           ///< mean over all cases; NaN without cases
  [[nodiscard]] double standardError() const;  ///< standard error of the mean; NaN for fewer than two runs

  /// Returns, for a quantity that is 0 or 1, Wilson's interval with the effective number of independent cases that
  /// gives standardError(). If all cases have the same value, this number is undetermined, and each run is counted as
  /// one case.
  [[nodiscard]] Probability probability() const;

  void put(TallyWords& words) const;
  static RunSums read(WordReader& reader);

  bool operator==(const RunSums&) const = default;

 private:
  std::uint64_t runs_ = 0, count_ = 0, squared_counts_ = 0;
  WideCount sum_ = 0, squares_ = 0, products_ = 0;
};

}  // namespace tubeplan::app
