// From a reading to the posture that the model is asked about.
#pragma once

#include <optional>

#include "calibration/measurements/measurement_kinds.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::calibration {

/// The posture that a reading states, for a base under which gravity has that direction (unit length, base axes). The
/// one place where a reading's conditions reach the model.
[[nodiscard]] inline deflection::Posture postureOf(const Measurement& reading, const Eigen::Vector3d& gravity_B) {
  deflection::Posture posture{reading.q, reading.load, gravity_B};
  posture.approach_directions = reading.approach_directions;
  posture.temperature = reading.temperature;
  posture.time = reading.time;
  posture.setup = reading.setup;
  return posture;
}

/// Of a displacement, the posture that it is taken from: the same without its load, or that of another reading.
[[nodiscard]] inline std::optional<deflection::Posture> referencePostureOf(const Measurement& reading,
                                                                           const Eigen::Vector3d& gravity_B) {
  if (!kindOf(reading).is_displacement) return std::nullopt;
  if (reading.reference) return postureOf(*reading.reference, gravity_B);
  deflection::Posture unloaded = postureOf(reading, gravity_B);
  unloaded.load = 0;
  return unloaded;
}

}  // namespace tubeplan::calibration
