// From a reading to the posture that the model is asked about.
#pragma once

#include <optional>

#include "calibration/measurements/measurement_kinds.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::calibration {

/// The posture that a reading states, for a base placed at X_WB. The one place where a reading's conditions reach the
/// model.
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

/// The reading that a displacement is taken from: another, or the same with nothing on its tip.
[[nodiscard]] inline Measurement readingAt(const Departure& from) {
  Measurement reading = *from.reading;
  if (!from.is_unloaded) return reading;
  reading.load = 0;
  reading.wrench.reset();
  return reading;
}

/// Of a displacement, the posture that it is taken from: the same without its load, or that of another reading.
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
