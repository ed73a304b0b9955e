// Kind `deflection`: the displacement x, y, z of the tip caused by its load, at unchanged joint readings.
#pragma once

#include "calibration/measurements/coordinates.hpp"

namespace tubeplan::calibration::deflection_measurement {

/// Returns the reference of the displacement: the same posture without load.
inline Departure departure(const Measurement& measurement) { return {&measurement, true}; }

inline MeasurementKindRow kind() {
  MeasurementKindRow row = coordinates::row(MeasurementKind::kDeflection, "deflection");
  row.departure = departure;
  return row;
}

}  // namespace tubeplan::calibration::deflection_measurement
