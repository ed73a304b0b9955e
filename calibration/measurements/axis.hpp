// Kind `axis`: the signed distance of the tip from the point x, y, z along the direction dx, dy, dz, as a dial
// indicator, a height gauge or a line laser measures it.
#pragma once

#include "calibration/measurements/distance.hpp"

namespace tubeplan::calibration::axis {

inline MeasuredValue value(const Measurement& reading, const ToolPose& tool) {
  return MeasuredValue::Constant(1, reading.direction_W->dot(tool.p_W - *reading.p_W));
}
inline MeasuredSlope slope(const Measurement& reading, const ToolPose&) {
  return {reading.direction_W->transpose(), {}};
}
inline void record(const ToolPose& tool, double scale, const MeasuredValue& noise, Measurement& reading) {
  reading.own[0] = scale * value(reading, tool)[0] + noise[0];
}

inline void state(const KnownPlaces& places, Measurement& reading) {
  distance::stateAnchor(places, reading);
  reading.direction_W = places.direction_W;
}

inline std::optional<ReadingLack> lack(const Measurement& reading, const std::string& kind) {
  if (!reading.p_W || reading.direction_W) return lackOfPlace(reading, kind);
  return ReadingLack{"the reading of kind " + kind + " has no direction",
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
