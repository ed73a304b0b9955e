// Kind `relative`: the displacement of the tip from its position at another reading, `reference`, as x, y, z in the
// world frame or as its length alone. It makes use of a known distance at an unknown position: two sockets of a jig,
// two holes one pitch apart, the travel that the scale of a linear stage shows.
#pragma once

#include "calibration/measurements/coordinates.hpp"
#include "calibration/measurements/distance.hpp"

namespace tubeplan::calibration::relative {

inline int rowsOf(const Measurement& reading) { return reading.p_W ? 3 : 1; }

/// Returns the predicted values; `tool.p_W` is the displacement from the reference.
inline MeasuredValue value(const Measurement& reading, const ToolPose& tool) {
  if (reading.p_W) return tool.p_W;
  return MeasuredValue::Constant(1, tool.p_W.norm());
}
inline MeasuredSlope slope(const Measurement& reading, const ToolPose& tool) {
  if (reading.p_W) return {Eigen::Matrix3d::Identity(), {}};
  return {tool.p_W.normalized().transpose(), {}};
}
inline MeasuredValue measured(const Measurement& reading) {
  return reading.p_W ? MeasuredValue(*reading.p_W) : distance::measured(reading);
}

/// Returns true if the reading states either the displacement's coordinates or a positive length, but not both.
inline bool isPossible(const Measurement& reading) {
  return reading.p_W ? std::isnan(reading.own[0]) : distance::isPossible(reading);
}

/// Returns the reference reading or, while none is set, this reading without load.
inline Departure departure(const Measurement& reading) {
  return reading.reference ? Departure{reading.reference.get(), false} : Departure{&reading, true};
}

inline MeasurementKindRow kind() {
  MeasurementKindRow row = coordinates::row(MeasurementKind::kRelative, "relative");
  row.rows_of = rowsOf;
  row.columns = distance::kColumns;
  row.is_from_reading = true;
  row.lack = nullptr;
  row.departure = departure;
  row.value_columns = placeOrOwn;
  row.is_possible = isPossible;
  row.value = value;
  row.slope = slope;
  row.measured = measured;
  return row;
}

}  // namespace tubeplan::calibration::relative
