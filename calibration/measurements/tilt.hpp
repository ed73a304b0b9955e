// Kind `tilt`: an inclinometer on the tool or on a row of the arm, which reads the angles of the frame's axes above the
// horizontal. A measurement states the angles of one, two or three axes. A vertical axis has no usable angle.
#pragma once

#include <algorithm>
#include <array>

#include "calibration/measurements/partly_seen.hpp"

namespace tubeplan::calibration::tilt {

inline constexpr std::array<MeasuredColumn, 3> kColumns{{{"tilt_x", deflection::Quantity::kAngle},
                                                         {"tilt_y", deflection::Quantity::kAngle},
                                                         {"tilt_z", deflection::Quantity::kAngle}}};
inline constexpr double kUpright = 1 - 1e-9;  // upper limit for sines, which keeps the derivative finite

/// Returns the sines of the three axes' angles above the horizontal; `direction_W` points up.
inline Eigen::Vector3d sines(const Measurement& measurement, const ToolPose& tool) {
  return (tool.R_WT.transpose() * *measurement.direction_W).cwiseMax(-kUpright).cwiseMin(kUpright);
}
inline MeasuredValue value(const Measurement& measurement, const ToolPose& tool) {
  return partly_seen::stated<MeasuredValue>(measurement, kTurnLever * sines(measurement, tool).array().asin().matrix());
}
inline MeasuredSlope slope(const Measurement& measurement, const ToolPose& tool) {
  const Eigen::Vector3d cosines = (1 - sines(measurement, tool).array().square()).sqrt();
  Eigen::Matrix3d by_turn;
  for (Eigen::Index k = 0; k < 3; ++k)
    by_turn.row(k) = kTurnLever / cosines[k] * tool.R_WT.col(k).cross(*measurement.direction_W).transpose();
  const int rows = partly_seen::statedRows(measurement);
  return {MeasuredRows::Zero(rows, 3), partly_seen::stated<MeasuredRows>(measurement, by_turn)};
}
inline MeasuredValue measured(const Measurement& measurement) {
  return partly_seen::stated<MeasuredValue>(measurement, kTurnLever * measurement.kind_values);
}
inline void record(const ToolPose& tool, double, const MeasuredValue& noise, Measurement& measurement) {
  const Eigen::Vector3d angles = sines(measurement, tool).array().asin();
  const Eigen::Index unmeasured = partly_seen::axisAlong(*measurement.direction_W, tool);
  measurement.kind_values = partly_seen::without(angles + noise.tail<3>() / kTurnLever, unmeasured);
}

inline void state(const KnownPlaces& places, Measurement& measurement) { measurement.direction_W = places.up_W; }

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kTilt,
          .name = "tilt",
          .turn_rows = 3,
          .rows_of = partly_seen::statedRows,
          .columns = kColumns,
          .is_to_gravity = true,
          .is_by_scale = false,
          .sees_turn = true,
          .may_be_of_row = true,
          .value = value,
          .slope = slope,
          .measured = measured,
          .record = record,
          .lack = nullptr,
          .value_columns = someKindColumns,
          .state = state};
}

}  // namespace tubeplan::calibration::tilt
