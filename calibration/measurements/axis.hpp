// How far the tip is beyond x, y, z along the direction dx, dy, dz, of either sign: a dial indicator, a height gauge, a
// laser that looks along a line.
#pragma once

#include "calibration/measurements/distance.hpp"

namespace tubeplan::calibration::axis {

inline MeasuredValue value(const Measurement& reading, const Eigen::Vector3d& p_W) {
  return MeasuredValue::Constant(1, reading.direction_W->dot(p_W - *reading.p_W));
}
inline MeasuredSlope slope(const Measurement& reading, const Eigen::Vector3d&) {
  return reading.direction_W->transpose();
}

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kAxis,
          .name = "axis",
          .rows = 1,
          .has_anchor = true,
          .has_direction = true,
          .value = value,
          .slope = slope,
          .measured = distance::measured,
          .record = distance::record};
}

}  // namespace tubeplan::calibration::axis
