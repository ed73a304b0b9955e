// The length of a wire or a laser's line from a fixed anchor x, y, z to the tip.
#pragma once

#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::calibration::distance {

inline MeasuredValue value(const Measurement& reading, const Eigen::Vector3d& p_W) {
  return MeasuredValue::Constant(1, (p_W - *reading.p_W).norm());
}
inline MeasuredSlope slope(const Measurement& reading, const Eigen::Vector3d& p_W) {
  return (p_W - *reading.p_W).normalized().transpose();
}
inline MeasuredValue measured(const Measurement& reading) { return MeasuredValue::Constant(1, reading.distance); }
inline void record(const MeasuredValue& value, Measurement& reading) { reading.distance = value[0]; }

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kDistance,
          .name = "distance",
          .rows = 1,
          .has_anchor = true,
          .is_above_zero = true,
          .value = value,
          .slope = slope,
          .measured = measured,
          .record = record};
}

}  // namespace tubeplan::calibration::distance
