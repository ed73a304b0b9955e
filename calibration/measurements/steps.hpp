// Kind `steps`: the number of steps of the calibration tool that entered the hole. The centring error lies between two
// tolerances, `kind_values[1]` and `kind_values[2]` [m]. If all steps entered, the tip is uniformly distributed in a
// disc. Otherwise, its distance from the hole's axis is uniformly distributed between the two tolerances. (A uniform
// disc of radius r has a standard deviation of r / 2 per coordinate; a length uniform between a and b has one of
// (b - a) / sqrt(12).)
#pragma once

#include <array>
#include <cmath>

#include "calibration/measurements/coordinates.hpp"

namespace tubeplan::calibration::steps {

inline constexpr std::array<MeasuredColumn, 1> kColumns{{{"steps", deflection::Quantity::kNone}}};

inline bool isDisc(const Measurement& measurement) { return !(measurement.kind_values[1] > 0); }
inline int rowsOf(const Measurement& measurement) { return isDisc(measurement) ? 2 : 1; }

/// Returns the tip's offset from the hole's axis, which is the world's z axis [m].
inline Eigen::Vector2d lateralOffset(const Measurement& measurement, const ToolPose& tool) {
  return (tool.p_W - *measurement.p_W).head<2>();
}
inline MeasuredValue value(const Measurement& measurement, const ToolPose& tool) {
  if (isDisc(measurement)) return lateralOffset(measurement, tool);
  return MeasuredValue::Constant(1, lateralOffset(measurement, tool).norm());
}
inline MeasuredSlope slope(const Measurement& measurement, const ToolPose& tool) {
  if (isDisc(measurement)) return {Eigen::Matrix<double, 2, 3>::Identity(), {}};
  const Eigen::Vector2d off = lateralOffset(measurement, tool);
  const Eigen::Vector2d along = off.norm() > 0 ? Eigen::Vector2d(off.normalized()) : Eigen::Vector2d::UnitX();
  return {Eigen::RowVector3d(along.x(), along.y(), 0), {}};
}
inline MeasuredValue measured(const Measurement& measurement) {
  if (isDisc(measurement)) return Eigen::Vector2d::Zero();
  return MeasuredValue::Constant(1, (measurement.kind_values[1] + measurement.kind_values[2]) / 2);
}
/// Writes the tip's offset in the place of the bounds; the simulator derives the number of steps from it.
inline void record(const ToolPose& tool, double, const MeasuredValue&, Measurement& measurement) {
  measurement.kind_values.tail<2>() = lateralOffset(measurement, tool);
}

/// Returns the standard deviation of each row [m] for a centring error between `lower` and `upper` [m].
inline double sigmaBetween(double lower, double upper) {
  return lower > 0 ? (upper - lower) / std::sqrt(12.) : upper / 2;
}

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kSteps,
          .name = "steps",
          .rows = 2,
          .rows_of = rowsOf,
          .columns = kColumns,
          .names_hole = true,
          .is_centring = true,
          .counts_steps = true,
          .is_by_scale = false,
          .value = value,
          .slope = slope,
          .measured = measured,
          .record = record,
          .usual_sigma = kVisitSigma,
          .state = coordinates::statePoint};
}

}  // namespace tubeplan::calibration::steps
