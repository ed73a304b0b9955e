// From a reading to the posture that the model is asked about.
#pragma once

#include "calibration/measurement.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::calibration {

/// The posture that a reading states, for a base under which gravity has that direction (unit length, base axes). The
/// one place where a reading's conditions reach the model.
[[nodiscard]] inline deflection::Posture postureOf(const Measurement& reading, const Eigen::Vector3d& gravity_B) {
  deflection::Posture posture{reading.q, reading.load, gravity_B};
  posture.senses = reading.senses;
  posture.temperature = reading.temperature;
  posture.time = reading.time;
  posture.setup = reading.setup;
  return posture;
}

}  // namespace tubeplan::calibration
