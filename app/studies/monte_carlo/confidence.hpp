// How sure figures from random runs are.
#pragma once

#include <cstdint>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

inline constexpr double kTwoSided95 = 1.959963984540054;  ///< sigmas of a 95 % interval

/// A share with its 95 % band.
struct Probability {
  double value, low, high;
};

/// Wilson's score interval (E. B. Wilson, J. Am. Stat. Assoc. 22, 1927): of `count` in `of` independent cases. NaN, 0
/// and 1 where there is none. Neither need be whole: an effective number of cases will do.
[[nodiscard]] Probability wilsonInterval(double count, double of);

/// Sums over runs of a quantity that each run has several of, runs being independent and what is in one not: the mean
/// of them all and its standard error by the ratio estimator (Cochran, Sampling Techniques, 1977, section 6.4). Whole
/// numbers, so that sums merged in any order are the same to the last bit.
class RunSums {
 public:
  /// One run: `sum` of the quantity over its `count` cases.
  void add(std::uint64_t sum, std::uint64_t count);
  void merge(const RunSums& other);

  [[nodiscard]] std::uint64_t runs() const { return runs_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double mean() const;           ///< NaN where there is no case
  [[nodiscard]] double standardError() const;  ///< of the mean; NaN below two runs

  /// Of a quantity that is 0 or 1: Wilson's interval with as many independent cases as give this standard error. Where
  /// all are alike nothing determines it: a run then counts as one case.
  [[nodiscard]] Probability probability() const;

  void put(TallyWords& words) const;
  static RunSums read(WordReader& reader);

  bool operator==(const RunSums&) const = default;

 private:
  std::uint64_t runs_ = 0, count_ = 0, squared_counts_ = 0;
  WideCount sum_ = 0, squares_ = 0, products_ = 0;
};

}  // namespace tubeplan::app
