// The middle one of some numbers.
#pragma once

#include <algorithm>
#include <vector>

namespace tubeplan::tubesheets {

/// The upper of the two in the middle where there are two. Not of none.
[[nodiscard]] inline double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace tubeplan::tubesheets
