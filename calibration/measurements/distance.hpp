// Kind `distance`: the length of a wire or a laser beam from a fixed anchor x, y, z to the tip.
#pragma once

#include <array>

#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::calibration::distance {

inline constexpr std::array<MeasuredColumn, 1> kColumns{{{"distance", deflection::Quantity::kLength}}};

inline MeasuredValue value(const Measurement& measurement, const ToolPose& tool) {
  return MeasuredValue::Constant(1, (tool.p_W - *measurement.p_W).norm());
}
inline MeasuredSlope slope(const Measurement& measurement, const ToolPose& tool) {
  return {(tool.p_W - *measurement.p_W).normalized().transpose(), {}};
}
inline bool isPossible(const Measurement& measurement) { return !(measurement.kind_values[0] <= 0); }
inline MeasuredValue measured(const Measurement& measurement) {
  return MeasuredValue::Constant(1, measurement.kind_values[0]);
}
inline void record(const ToolPose& tool, double scale, const MeasuredValue& noise, Measurement& measurement) {
  measurement.kind_values[0] = scale * value(measurement, tool)[0] + noise[0];
}

/// Copies the anchor's position or, if no anchor is given, the world's origin into the measurement.
inline void stateAnchor(const KnownPlaces& places, Measurement& measurement) {
  measurement.p_W = places.anchor_W.value_or(Eigen::Vector3d::Zero());
}

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kDistance,
          .name = "distance",
          .rows = 1,
          .columns = kColumns,
          .has_anchor = true,
          .value = value,
          .slope = slope,
          .measured = measured,
          .record = record,
          .is_possible = isPossible,
          .state = stateAnchor};
}

}  // namespace tubeplan::calibration::distance
