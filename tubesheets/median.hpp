// The median of a list of values.
#pragma once

#include <algorithm>
#include <vector>

namespace tubeplan::tubesheets {

/// Returns the median of `values`, which must not be empty; for an even number of values, the larger of the middle two.
[[nodiscard]] inline double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace tubeplan::tubesheets
