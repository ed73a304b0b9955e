// The median.
#pragma once

#include <algorithm>
#include <vector>

namespace tubeplan::tubesheets {

/// Returns the median; of an even number of values, the upper of the middle two. `values` must not be empty.
[[nodiscard]] inline double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace tubeplan::tubesheets
