// Kind `pose`: the whole tool frame: position x, y, z of the tip and rotation roll, pitch, yaw (as from a tracker's
// six-degree probe).
#pragma once

#include "calibration/measurements/coordinates.hpp"
#include "calibration/measurements/orientation.hpp"

namespace tubeplan::calibration::pose {

inline MeasuredValue joined(const Eigen::Vector3d& place, const Eigen::Vector3d& turn) {
  Eigen::Matrix<double, 6, 1> rows;
  rows << place, turn;
  return rows;
}
inline MeasuredValue value(const Measurement& measurement, const ToolPose& tool) {
  return joined(tool.p_W, orientation::value(measurement, tool));
}
inline MeasuredSlope slope(const Measurement& measurement, const ToolPose& tool) {
  Eigen::Matrix<double, 6, 3> by_place, by_turn;
  by_place << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
  by_turn << Eigen::Matrix3d::Zero(), orientation::slope(measurement, tool).by_turn;
  return {by_place, by_turn};
}
inline MeasuredValue measured(const Measurement& measurement) {
  return joined(*measurement.p_W, Eigen::Vector3d::Zero());
}
inline void record(const ToolPose& tool, double scale, const MeasuredValue& noise, Measurement& measurement) {
  coordinates::record(tool, scale, noise, measurement);
  orientation::record(tool, scale, noise, measurement);
}

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kPose,
          .name = "pose",
          .rows = 6,
          .turn_rows = 3,
          .columns = orientation::kColumns,
          .has_coordinates = true,
          .is_place = true,
          .sees_turn = true,
          .value = value,
          .slope = slope,
          .measured = measured,
          .record = record,
          .value_columns = placeAndKindColumns};
}

}  // namespace tubeplan::calibration::pose
