// The tip's place, as a laser tracker sees it: x, y, z.
#pragma once

#include "calibration/measurements/coordinates.hpp"

namespace tubeplan::calibration::position {

inline MeasurementKindRow kind() {
  MeasurementKindRow row = coordinates::row(MeasurementKind::kPosition, "position");
  row.is_place = true;
  return row;
}

}  // namespace tubeplan::calibration::position
