// How far the tip moves by its load, the joint readings unchanged: x, y, z.
#pragma once

#include "calibration/measurements/coordinates.hpp"

namespace tubeplan::calibration::deflection_reading {

inline MeasurementKindRow kind() {
  MeasurementKindRow row = coordinates::row(MeasurementKind::kDeflection, "deflection");
  row.is_displacement = true;
  return row;
}

}  // namespace tubeplan::calibration::deflection_reading
