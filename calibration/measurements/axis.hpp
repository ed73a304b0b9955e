// Kind `axis`: the signed distance of the tip from the point x, y, z along the direction dx, dy, dz, as a dial
// indicator, a height gauge or a line laser measures it.
#pragma once

#include "calibration/measurements/distance.hpp"

namespace tubeplan::calibration::axis {

inline MeasuredValue value(const Measurement& measurement, const ToolPose& tool) {
  return MeasuredValue::Constant(1, measurement.direction_W->dot(tool.p_W - *measurement.p_W));
}
inline MeasuredSlope slope(const Measurement& measurement, const ToolPose&) {
  return {measurement.direction_W->transpose(), {}};
}
inline void record(const ToolPose& tool, double scale, const MeasuredValue& noise, Measurement& measurement) {
  measurement.kind_values[0] = scale * value(measurement, tool)[0] + noise[0];
}

inline void state(const KnownPlaces& places, Measurement& measurement) {
  distance::stateAnchor(places, measurement);
  measurement.direction_W = places.direction_W;
}

inline std::optional<MeasurementLack> lack(const Measurement& measurement, const std::string& kind) {
  if (!measurement.p_W || measurement.direction_W) return lackOfPlace(measurement, kind);
  return MeasurementLack{"the reading of kind " + kind + " has no direction",
                         "write its direction in the columns dx, dy, dz (of any length)"};
}

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kAxis,
          .name = "axis",
          .rows = 1,
          .columns = distance::kColumns,
          .has_anchor = true,
          .has_direction = true,
          .value = value,
          .slope = slope,
          .measured = distance::measured,
          .record = record,
          .lack = lack,
          .state = state};
}

}  // namespace tubeplan::calibration::axis
