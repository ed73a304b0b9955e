// Kind `direction`: the direction of the x axis of the tool frame or of a row's frame, in the world frame. It is stated
// as azimuth from x towards y and altitude above the xy plane (an altazimuth mount's line of sight, a beam on a tool).
// The error is the angle from the measured to the predicted direction, resolved along the circle of equal altitude and
// upwards. Both components are angles on the sphere, so the azimuth has less weight near the zenith.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "calibration/measurements/measurement_kind.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration::direction {

inline constexpr std::array<MeasuredColumn, 2> kColumns{
    {{"azimuth", deflection::Quantity::kAngle}, {"altitude", deflection::Quantity::kAngle}}};

/// Returns the rotation from the measured frame to the world frame, whose columns point across, upwards and along the
/// measured direction.
inline Eigen::Matrix3d frameOf(double azimuth, double elevation) {
  const double ca = std::cos(azimuth), sa = std::sin(azimuth), ce = std::cos(elevation), se = std::sin(elevation);
  Eigen::Matrix3d R_WM;
  R_WM << -sa, -ca * se, ca * ce, ca, -sa * se, sa * ce, 0, ce, se;
  return R_WM;
}

/// Angle [rad] between a direction and the third axis, resolved towards the first and the second axis, with the
/// derivatives with respect to the direction.
struct Deviation {
  Eigen::Vector2d angles;
  Eigen::Matrix<double, 2, 3> slope;
};
inline Deviation deviationOf(const Eigen::Vector3d& direction_M) {
  const Eigen::Vector2d lateral = direction_M.head<2>();
  const double sine = lateral.norm(), angle = std::atan2(sine, direction_M.z());
  Deviation deviation{lateral, Eigen::Matrix<double, 2, 3>::Zero()};
  if (sine < 1e-8) {  // for small angles, the angle equals its sine
    deviation.slope.leftCols<2>().setIdentity();
    return deviation;
  }
  const Eigen::Vector2d along = lateral / sine;
  deviation.angles = angle * along;
  deviation.slope.leftCols<2>() = angle / sine * (Eigen::Matrix2d::Identity() - along * along.transpose());
  deviation.slope.leftCols<2>() += direction_M.z() * along * along.transpose();
  deviation.slope.col(2) = -sine * along;
  return deviation;
}

inline Eigen::Vector3d seenFrom(const Eigen::Matrix3d& R_WM, const ToolPose& tool) {
  return R_WM.transpose() * tool.R_WT.col(0);
}
inline MeasuredValue value(const Measurement& measurement, const ToolPose& tool) {
  return kTurnLever *
         deviationOf(seenFrom(frameOf(measurement.kind_values[0], measurement.kind_values[1]), tool)).angles;
}
inline MeasuredSlope slope(const Measurement& measurement, const ToolPose& tool) {
  const Eigen::Matrix3d R_WM = frameOf(measurement.kind_values[0], measurement.kind_values[1]);
  const Eigen::Matrix3d by_turn = -R_WM.transpose() * deflection::crossMatrix<double>(tool.R_WT.col(0));
  return {MeasuredRows::Zero(2, 3), kTurnLever * deviationOf(seenFrom(R_WM, tool)).slope * by_turn};
}
inline MeasuredValue measured(const Measurement&) { return MeasuredValue::Zero(2); }

/// Writes the predicted direction, rotated across and upwards by the noise.
inline void record(const ToolPose& tool, double, const MeasuredValue& noise, Measurement& measurement) {
  const auto anglesOf = [](const Eigen::Vector3d& d) {
    return Eigen::Vector2d(std::atan2(d.y(), d.x()), std::atan2(d.z(), d.head<2>().norm()));
  };
  const Eigen::Vector2d angles = anglesOf(tool.R_WT.col(0));
  const Eigen::Matrix3d R_WM = frameOf(angles[0], angles[1]);
  const Eigen::Vector3d off(noise[0] / kTurnLever, noise[1] / kTurnLever, 1);
  measurement.kind_values.head<2>() = anglesOf(R_WM * off);
}

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kDirection,
          .name = "direction",
          .rows = 2,
          .turn_rows = 2,
          .columns = kColumns,
          .is_by_scale = false,
          .sees_turn = true,
          .may_be_of_row = true,
          .value = value,
          .slope = slope,
          .measured = measured,
          .record = record,
          .lack = nullptr};
}

}  // namespace tubeplan::calibration::direction
