// How far the tip moves by its load, the joint readings unchanged.
#pragma once

#include "calibration/measurements/coordinates.hpp"

namespace tubeplan::calibration::deflection_reading {

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kDeflection,
          .name = "deflection",
          .summary = "the tip's displacement by its load from where it is unloaded: x, y, z",
          .is_displacement = true,
          .value = coordinates::value,
          .slope = coordinates::slope,
          .measured = coordinates::measured,
          .record = coordinates::record};
}

}  // namespace tubeplan::calibration::deflection_reading
