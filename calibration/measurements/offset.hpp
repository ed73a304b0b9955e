// Kind `offset`: the centre of a hole or mark at x, y, z relative to the tip, in the tool frame, as measured by a
// camera on the tool. A measurement states only the components that the camera sees.
#pragma once

#include <array>

#include "calibration/measurements/coordinates.hpp"
#include "calibration/measurements/partly_seen.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration::offset {

inline constexpr std::array<MeasuredColumn, 3> kColumns{{{"offset_x", deflection::Quantity::kLength},
                                                         {"offset_y", deflection::Quantity::kLength},
                                                         {"offset_z", deflection::Quantity::kLength}}};

inline Eigen::Vector3d seen(const Measurement& measurement, const ToolPose& tool) {
  return tool.R_WT.transpose() * (*measurement.p_W - tool.p_W);
}
inline MeasuredValue value(const Measurement& measurement, const ToolPose& tool) {
  return partly_seen::stated<MeasuredValue>(measurement, seen(measurement, tool));
}
inline MeasuredSlope slope(const Measurement& measurement, const ToolPose& tool) {
  const Eigen::Matrix3d R_TW = tool.R_WT.transpose();
  const Eigen::Vector3d away = *measurement.p_W - tool.p_W;
  return {partly_seen::stated<MeasuredRows>(measurement, -R_TW),
          partly_seen::stated<MeasuredRows>(measurement, R_TW * deflection::crossMatrix(away))};
}
inline MeasuredValue measured(const Measurement& measurement) {
  return partly_seen::stated<MeasuredValue>(measurement, measurement.kind_values);
}
/// Writes the components seen by a camera that looks along the world's z axis, which is the axis of the holes.
inline void record(const ToolPose& tool, double, const MeasuredValue& noise, Measurement& measurement) {
  const Eigen::Index unmeasured = partly_seen::axisAlong(Eigen::Vector3d::UnitZ(), tool);
  measurement.kind_values = partly_seen::without(seen(measurement, tool) + noise.head<3>(), unmeasured);
}

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kOffset,
          .name = "offset",
          .rows_of = partly_seen::statedRows,
          .columns = kColumns,
          .names_hole = true,
          .is_by_scale = false,
          .sees_turn = true,
          .value = value,
          .slope = slope,
          .measured = measured,
          .record = record,
          .value_columns = someKindColumns,
          .state = coordinates::statePoint};
}

}  // namespace tubeplan::calibration::offset
