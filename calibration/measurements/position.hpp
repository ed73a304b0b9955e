// Kind `position`: the tip's position x, y, z, as a laser tracker measures it.
#pragma once

#include "calibration/measurements/coordinates.hpp"

namespace tubeplan::calibration::position {

inline MeasurementKindRow kind() {
  MeasurementKindRow row = coordinates::row(MeasurementKind::kPosition, "position");
  row.is_place = true;
  return row;
}

}  // namespace tubeplan::calibration::position
