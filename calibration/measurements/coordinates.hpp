// Functions shared by the kinds that measure all three coordinates: a tracker's position, a touched point, a
// displacement.
#pragma once

#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::calibration::coordinates {

inline MeasuredValue value(const Measurement&, const ToolPose& tool) { return tool.p_W; }
inline MeasuredSlope slope(const Measurement&, const ToolPose&) { return {Eigen::Matrix3d::Identity(), {}}; }
inline MeasuredValue measured(const Measurement& measurement) {
  return measurement.p_W ? *measurement.p_W : Eigen::Vector3d::Zero();
}
inline void record(const ToolPose& tool, double scale, const MeasuredValue& noise, Measurement& measurement) {
  measurement.p_W = scale * tool.p_W + noise.head<3>();
}

/// Copies the position of the hole or mark, if known, into the measurement.
inline void statePoint(const KnownPlaces& places, Measurement& measurement) { measurement.p_W = places.point_W; }

inline MeasurementKindRow row(MeasurementKind kind, const char* name) {
  return {.kind = kind,
          .name = name,
          .has_coordinates = true,
          .value = value,
          .slope = slope,
          .measured = measured,
          .record = record,
          .value_columns = placeAndKindColumns};
}

}  // namespace tubeplan::calibration::coordinates
