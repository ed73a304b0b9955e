// Kind `relative`: the displacement of the tip from its position at another measurement, `reference`, as x, y, z in the
// world frame or as its length alone. It makes use of a known distance at an unknown position, such as two sockets of a
// jig, two holes one pitch apart, or the travel of a linear stage.
#pragma once

#include "calibration/measurements/coordinates.hpp"
#include "calibration/measurements/distance.hpp"

namespace tubeplan::calibration::relative {

inline int rowsOf(const Measurement& measurement) { return measurement.p_W ? 3 : 1; }

/// Returns the predicted values; `tool.p_W` is the displacement from the reference.
inline MeasuredValue value(const Measurement& measurement, const ToolPose& tool) {
  if (measurement.p_W) return tool.p_W;
  return MeasuredValue::Constant(1, tool.p_W.norm());
}
inline MeasuredSlope slope(const Measurement& measurement, const ToolPose& tool) {
  if (measurement.p_W) return {Eigen::Matrix3d::Identity(), {}};
  return {tool.p_W.normalized().transpose(), {}};
}
inline MeasuredValue measured(const Measurement& measurement) {
  return measurement.p_W ? MeasuredValue(*measurement.p_W) : distance::measured(measurement);
}

/// Returns true if the measurement states either the displacement's coordinates or a positive length, but not both.
inline bool isPossible(const Measurement& measurement) {
  return measurement.p_W ? std::isnan(measurement.kind_values[0]) : distance::isPossible(measurement);
}

/// Returns the reference measurement or, while none is set, this measurement without load.
inline Departure departure(const Measurement& measurement) {
  return measurement.reference ? Departure{measurement.reference.get(), false} : Departure{&measurement, true};
}

inline MeasurementKindRow kind() {
  MeasurementKindRow row = coordinates::row(MeasurementKind::kRelative, "relative");
  row.rows_of = rowsOf;
  row.columns = distance::kColumns;
  row.is_from_measurement = true;
  row.lack = nullptr;
  row.departure = departure;
  row.value_columns = placeOrKindColumns;
  row.is_possible = isPossible;
  row.value = value;
  row.slope = slope;
  row.measured = measured;
  return row;
}

}  // namespace tubeplan::calibration::relative
