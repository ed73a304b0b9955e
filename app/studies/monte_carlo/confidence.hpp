// Confidence intervals of figures from random runs.
#pragma once

#include <cstdint>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

inline constexpr double kTwoSided95 = 1.959963984540054;  ///< sigmas of a 95 % interval

/// A share with its 95 % interval.
struct Probability {
  double value, low, high;
};

/// Returns Wilson's score interval (E. B. Wilson, J. Am. Stat. Assoc. 22, 1927) for `count` in `of` independent cases;
/// NaN, 0 and 1 without cases. Neither need be whole: an effective number of cases is allowed.
[[nodiscard]] Probability wilsonInterval(double count, double of);

/// Sums over independent runs of a quantity that each run has several dependent cases of. They give the mean of all
/// cases and its standard error by the ratio estimator (Cochran, Sampling Techniques, 1977, section 6.4). The sums are
/// whole numbers: merged in any order they are the same to the last bit.
class RunSums {
 public:
  /// Adds one run: `sum` of the quantity over its `count` cases.
  void add(std::uint64_t sum, std::uint64_t count);
  void merge(const RunSums& other);

  [[nodiscard]] std::uint64_t runs() const { return runs_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double mean() const;           ///< NaN without cases
  [[nodiscard]] double standardError() const;  ///< standard error of the mean; NaN below two runs

  /// Returns, for a quantity that is 0 or 1, Wilson's interval with the number of independent cases that gives this
  /// standard error. If all cases are alike, nothing determines that number: a run then counts as one case.
  [[nodiscard]] Probability probability() const;

  void put(TallyWords& words) const;
  static RunSums read(WordReader& reader);

  bool operator==(const RunSums&) const = default;

 private:
  std::uint64_t runs_ = 0, count_ = 0, squared_counts_ = 0;
  WideCount sum_ = 0, squares_ = 0, products_ = 0;
};

}  // namespace tubeplan::app
