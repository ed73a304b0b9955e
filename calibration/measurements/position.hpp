// The tip's place, as a laser tracker sees it.
#pragma once

#include "calibration/measurements/coordinates.hpp"

namespace tubeplan::calibration::position {

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kPosition,
          .name = "position",
          .summary = "the tip's place: x, y, z",
          .is_place = true,
          .value = coordinates::value,
          .slope = coordinates::slope,
          .measured = coordinates::measured,
          .record = coordinates::record};
}

}  // namespace tubeplan::calibration::position
