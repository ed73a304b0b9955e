// What several estimators ask of a sample.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace tubeplan::calibration {

/// Of an even number the upper of the two in the middle; NaN of none.
[[nodiscard]] inline double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace tubeplan::calibration
