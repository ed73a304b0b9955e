// Kind `deflection`: the displacement of the tip by its load, with the joint readings unchanged, as x, y, z.
#pragma once

#include "calibration/measurements/coordinates.hpp"

namespace tubeplan::calibration::deflection_reading {

/// Returns the same posture unloaded, from which the displacement is taken.
inline Departure departure(const Measurement& reading) { return {&reading, true}; }

inline MeasurementKindRow kind() {
  MeasurementKindRow row = coordinates::row(MeasurementKind::kDeflection, "deflection");
  row.departure = departure;
  return row;
}

}  // namespace tubeplan::calibration::deflection_reading
