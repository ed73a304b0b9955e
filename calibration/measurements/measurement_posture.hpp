// Conversion of a reading's joints, loads and conditions to a posture, the input of the arm model.
#pragma once

#include <optional>

#include "calibration/measurements/measurement_kinds.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::calibration {

/// Returns the posture that a reading states, for a base at `X_WB`. All conditions of a reading reach the model through
/// this function.
[[nodiscard]] inline deflection::Posture postureOf(const Measurement& reading, const deflection::Arm& arm,
                                                   const Eigen::Isometry3d& X_WB) {
  deflection::Posture posture{reading.q, reading.load, deflection::gravityInBase(arm, X_WB)};
  if (reading.wrench) {
    const Eigen::Matrix3d R_BW = X_WB.linear().transpose();
    posture.wrench = deflection::Wrench{R_BW * reading.wrench->force_W, R_BW * reading.wrench->moment_W};
  }
  posture.side_q = reading.side_q;
  posture.approach_directions = reading.approach_directions;
  posture.conditions = reading.conditions;
  posture.setup = reading.setup;
  return posture;
}

/// Returns the reference reading of a displacement: another reading, or the same reading without load on its tip.
[[nodiscard]] inline Measurement readingAt(const Departure& from) {
  Measurement reading = *from.reading;
  if (!from.is_unloaded) return reading;
  reading.load = 0;
  reading.wrench.reset();
  return reading;
}

/// Returns the reference posture of a displacement: the same posture without load, or that of another reading. Empty if
/// the reading is not a displacement.
[[nodiscard]] inline std::optional<deflection::Posture> referencePostureOf(const Measurement& reading,
                                                                           const deflection::Arm& arm,
                                                                           const Eigen::Isometry3d& X_WB) {
  const auto from = departureOf(reading);
  if (!from) return std::nullopt;
  auto posture = postureOf(*from->reading, arm, X_WB);
  if (from->is_unloaded) posture.load = 0, posture.wrench.reset();
  return posture;
}

}  // namespace tubeplan::calibration
