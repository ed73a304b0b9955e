// How far the tip moves by its load, the joint readings unchanged: x, y, z.
#pragma once

#include "calibration/measurements/coordinates.hpp"

namespace tubeplan::calibration::deflection_reading {

/// From where the tip rests unloaded at the same joint readings.
inline Departure departure(const Measurement& reading) { return {&reading, true}; }

inline MeasurementKindRow kind() {
  MeasurementKindRow row = coordinates::row(MeasurementKind::kDeflection, "deflection");
  row.departure = departure;
  return row;
}

}  // namespace tubeplan::calibration::deflection_reading
