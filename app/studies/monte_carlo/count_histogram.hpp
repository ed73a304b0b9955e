// Histogram of small counts, such as numbers of visits. All values are sums of integers, so that histograms merged in
// any order are identical.
#pragma once

#include <cstdint>
#include <vector>

#include "app/studies/monte_carlo/tally_words.hpp"

namespace tubeplan::app {

class CountHistogram {
 public:
  void add(std::size_t value);
  void merge(const CountHistogram& other);

  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] double mean() const;  ///< mean value; NaN without values

  /// Returns the smallest value that at least a `share` of all values do not exceed; NaN without values.
  [[nodiscard]] double quantile(double share) const;

  void put(TallyWords& words) const;
  static CountHistogram read(WordReader& reader);

  bool operator==(const CountHistogram&) const = default;

 private:
  std::vector<std::uint64_t> counts_;  ///< number of occurrences of each value, up to the largest value
};

}  // namespace tubeplan::app
