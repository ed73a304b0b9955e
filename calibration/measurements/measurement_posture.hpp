// Conversion of a measurement's joints, loads and conditions to a posture, the input of the arm model.
#pragma once

#include <optional>

#include "calibration/measurements/measurement_kinds.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::calibration {

/// Returns the posture that a measurement states, for a base at `X_WB`. All conditions of a measurement reach the model
/// through this function.
[[nodiscard]] inline deflection::Posture postureOf(const Measurement& measurement, const deflection::Arm& arm,
                                                   const Eigen::Isometry3d& X_WB) {
  deflection::Posture posture{measurement.q, measurement.load, deflection::gravityInBase(arm, X_WB)};
  if (measurement.wrench) {
    const Eigen::Matrix3d R_BW = X_WB.linear().transpose();
    posture.wrench = deflection::Wrench{R_BW * measurement.wrench->force_W, R_BW * measurement.wrench->moment_W};
  }
  posture.side_q = measurement.side_q;
  posture.approach_directions = measurement.approach_directions;
  posture.conditions = measurement.conditions;
  posture.setup = measurement.setup;
  return posture;
}

/// Returns the reference measurement of a displacement: another measurement, or the same measurement without load on
/// its tip.
[[nodiscard]] inline Measurement measurementAt(const Departure& from) {
  Measurement measurement = *from.measurement;
  if (!from.is_unloaded) return measurement;
  measurement.load = 0;
  measurement.wrench.reset();
  return measurement;
}

/// Returns the reference posture of a displacement: the same posture without load, or the posture of another
/// measurement. Empty if the measurement is not a displacement.
[[nodiscard]] inline std::optional<deflection::Posture> referencePostureOf(const Measurement& measurement,
                                                                           const deflection::Arm& arm,
                                                                           const Eigen::Isometry3d& X_WB) {
  const auto from = departureOf(measurement);
  if (!from) return std::nullopt;
  auto posture = postureOf(*from->measurement, arm, X_WB);
  if (from->is_unloaded) posture.load = 0, posture.wrench.reset();
  return posture;
}

}  // namespace tubeplan::calibration
