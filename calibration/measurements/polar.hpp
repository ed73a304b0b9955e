// Kind `polar`: the raw readings of a tracker or a total station: the slope distance to the tip, the horizontal angle
// from the world's x towards y, and the vertical angle above the xy plane. The station is at x, y, z (by default the
// world's origin), and its axes are the world's. Distances and angles have separate noise, so near and far measurements
// get appropriate weights.
#pragma once

#include <array>
#include <cmath>

#include "calibration/measurements/distance.hpp"

namespace tubeplan::calibration::polar {

inline constexpr std::array<MeasuredColumn, 3> kColumns{{{"range", deflection::Quantity::kLength},
                                                         {"horizontal", deflection::Quantity::kAngle},
                                                         {"vertical", deflection::Quantity::kAngle}}};

inline Eigen::Vector3d wayTo(const Measurement& measurement, const ToolPose& tool) {
  return tool.p_W - *measurement.p_W;
}

/// Returns the range [m], then the horizontal and the vertical angle [rad], of a vector from the station.
inline Eigen::Vector3d numbersOf(const Eigen::Vector3d& way) {
  return {way.norm(), std::atan2(way.y(), way.x()), std::atan2(way.z(), way.head<2>().norm())};
}
/// Returns the predicted values. The horizontal angle is relative to the measured one, wrapped to half a turn.
inline MeasuredValue value(const Measurement& measurement, const ToolPose& tool) {
  const Eigen::Vector3d predicted = numbersOf(wayTo(measurement, tool));
  const double off = std::remainder(predicted[1] - measurement.kind_values[1], 2 * EIGEN_PI);
  return Eigen::Vector3d(predicted[0], kTurnLever * off, kTurnLever * predicted[2]);
}
inline MeasuredSlope slope(const Measurement& measurement, const ToolPose& tool) {
  const Eigen::Vector3d way = wayTo(measurement, tool);
  const double range = way.norm(), across = way.head<2>().norm();
  Eigen::Matrix3d by_place;
  by_place.row(0) = way.transpose() / range;
  by_place.row(1) = kTurnLever / (across * across) * Eigen::RowVector3d(-way.y(), way.x(), 0);
  by_place.row(2) = kTurnLever / (range * range) *
                    Eigen::RowVector3d(-way.z() * way.x() / across, -way.z() * way.y() / across, across);
  return {by_place, {}};
}
inline MeasuredValue measured(const Measurement& measurement) {
  return Eigen::Vector3d(measurement.kind_values[0], 0, kTurnLever * measurement.kind_values[2]);
}
inline void record(const ToolPose& tool, double scale, const MeasuredValue& noise, Measurement& measurement) {
  const Eigen::Vector3d predicted = numbersOf(wayTo(measurement, tool));
  measurement.kind_values = {scale * predicted[0] + noise[0], predicted[1] + noise[1] / kTurnLever,
                             predicted[2] + noise[2] / kTurnLever};
}

inline Eigen::Vector3d place(const Measurement& measurement) {
  const double across = measurement.kind_values[0] * std::cos(measurement.kind_values[2]);
  return *measurement.p_W + Eigen::Vector3d(across * std::cos(measurement.kind_values[1]),
                                            across * std::sin(measurement.kind_values[1]),
                                            measurement.kind_values[0] * std::sin(measurement.kind_values[2]));
}

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kPolar,
          .name = "polar",
          .turn_rows = 2,
          .columns = kColumns,
          .has_anchor = true,
          .is_from_origin = true,
          .value = value,
          .slope = slope,
          .measured = measured,
          .record = record,
          .is_possible = distance::isPossible,
          .state = distance::stateAnchor,
          .place = place};
}

}  // namespace tubeplan::calibration::polar
