// Kind `orientation`: the rotation of the tool frame in the world frame as fixed angles roll, pitch, yaw, with the same
// definition as `rpy` of the base (measured by a probe or a camera on the tool and already corrected for its mounting).
// The error is the rotation vector from the measured to the predicted frame.
#pragma once

#include <array>

#include "calibration/measurements/measurement_kind.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration::orientation {

inline constexpr std::array<MeasuredColumn, 3> kColumns{{{"roll", deflection::Quantity::kAngle},
                                                         {"pitch", deflection::Quantity::kAngle},
                                                         {"yaw", deflection::Quantity::kAngle}}};

/// Returns the rotation vector from the measured frame to the tool frame, in world axes [rad].
inline Eigen::Vector3d turnFromMeasured(const Measurement& measurement, const ToolPose& tool) {
  const Eigen::Matrix3d R_WM = deflection::rotationFromFixedAngles<double>(measurement.kind_values);
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(tool.R_WT * R_WM.transpose()));
  return turn.angle() * turn.axis();
}

inline MeasuredValue value(const Measurement& measurement, const ToolPose& tool) {
  return kTurnLever * turnFromMeasured(measurement, tool);
}
inline MeasuredSlope slope(const Measurement& measurement, const ToolPose& tool) {
  return {Eigen::Matrix3d::Zero(),
          kTurnLever * deflection::leftJacobian(turnFromMeasured(measurement, tool)).inverse()};
}
inline MeasuredValue measured(const Measurement&) { return Eigen::Vector3d::Zero(); }
inline void record(const ToolPose& tool, double, const MeasuredValue& noise, Measurement& measurement) {
  const Eigen::Vector3d turn = noise.tail<3>() / kTurnLever;
  measurement.kind_values = deflection::fixedAnglesOf(deflection::rotationFromVector<double>(turn) * tool.R_WT);
}

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kOrientation,
          .name = "orientation",
          .turn_rows = 3,
          .columns = kColumns,
          .is_by_scale = false,
          .sees_turn = true,
          .value = value,
          .slope = slope,
          .measured = measured,
          .record = record,
          .lack = nullptr};
}

}  // namespace tubeplan::calibration::orientation
