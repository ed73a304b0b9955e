#include "calibration/diagnosis/set_aside.hpp"

#include <algorithm>
#include <map>

#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::calibration {

namespace {

/// How many touches each unknown point is left without these readings.
std::map<std::string, int> touchesLeft(const std::vector<int>& set_aside, const std::vector<Measurement>& readings) {
  std::map<std::string, int> left;
  for (std::size_t k = 0; k < readings.size(); ++k)
    if (!readings[k].is_held_out && touchesUnknownPoint(readings[k]))
      left[readings[k].point] += !std::binary_search(set_aside.begin(), set_aside.end(), static_cast<int>(k));
  return left;
}

}  // namespace

std::vector<int> withOrphans(const std::vector<int>& outliers, const std::vector<Measurement>& readings) {
  const auto isLeft = [&](std::size_t k) {
    return !readings[k].is_held_out && !std::binary_search(outliers.begin(), outliers.end(), static_cast<int>(k));
  };
  const auto touches = touchesLeft(outliers, readings);
  std::vector<int> all = outliers;
  for (std::size_t k = 0; k < readings.size(); ++k)
    if (isLeft(k) && touchesUnknownPoint(readings[k]) && touches.at(readings[k].point) == 1)
      all.push_back(static_cast<int>(k));
  std::sort(all.begin(), all.end());
  return all;
}

double countOutliers(const std::vector<int>& set_aside, const std::vector<Measurement>& readings) {
  const auto left = touchesLeft(set_aside, readings);
  const auto gone = std::count_if(left.begin(), left.end(), [](const auto& point) { return point.second == 0; });
  return static_cast<double>(set_aside.size()) - static_cast<double>(gone);
}

std::vector<int> othersThan(const std::vector<int>& set_aside, std::size_t readings) {
  std::vector<int> others;
  for (int k = 0; k < static_cast<int>(readings); ++k)
    if (!std::binary_search(set_aside.begin(), set_aside.end(), k)) others.push_back(k);
  return others;
}

}  // namespace tubeplan::calibration
