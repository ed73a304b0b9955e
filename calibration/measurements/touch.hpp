// The tip rests centred at a point, which several readings may share; its place is known or not.
#pragma once

#include "calibration/measurements/coordinates.hpp"

namespace tubeplan::calibration::touch {

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kTouch,
          .name = "touch",
          .summary =
              "the tip rests centred at `point`: x, y, z where its place is known, or a hole of the sheet by its name",
          .is_touch = true,
          .is_place = true,
          .needs_coordinates = false,
          .value = coordinates::value,
          .slope = coordinates::slope,
          .measured = coordinates::measured,
          .record = coordinates::recordNothing};
}

}  // namespace tubeplan::calibration::touch
