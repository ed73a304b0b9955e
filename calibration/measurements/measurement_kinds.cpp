#include "calibration/measurements/measurement_kinds.hpp"

#include <algorithm>
#include <array>

#include "calibration/measurements/axis.hpp"
#include "calibration/measurements/deflection.hpp"
#include "calibration/measurements/distance.hpp"
#include "calibration/measurements/position.hpp"
#include "calibration/measurements/touch.hpp"

namespace tubeplan::calibration {

std::span<const MeasurementKindRow> measurementKinds() {
  static const std::array kKinds{position::kind(), touch::kind(), deflection_reading::kind(), distance::kind(),
                                 axis::kind()};
  return kKinds;
}

const MeasurementKindRow& kindOf(MeasurementKind kind) { return measurementKinds()[static_cast<std::size_t>(kind)]; }

const MeasurementKindRow* findMeasurementKind(std::string_view name) {
  const auto kinds = measurementKinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& row) { return row.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

std::vector<std::string> measurementKindNames() {
  std::vector<std::string> names;
  for (const MeasurementKindRow& row : measurementKinds()) names.emplace_back(row.name);
  return names;
}

}  // namespace tubeplan::calibration
