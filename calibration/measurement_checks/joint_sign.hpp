// Mistake: the readings of a joint have the opposite sign.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::joint_sign {

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  return deflection::jointNames(checked.start.arm);
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const int joint = jointNamed(checked.start.arm, value);
  if (joint < 0) return std::nullopt;
  Correction correction{"joint-sign", value, value + " is read with the other sign"};
  correction.change = toEach([joint](Measurement& measurement) {
    measurement.q[joint] = -measurement.q[joint];
    if (!measurement.approach_directions.empty())
      measurement.approach_directions[static_cast<std::size_t>(joint)] *= -1;
  });
  return correction;
}

inline MistakeKind kind() { return {"joint-sign", "JOINT", "a joint of the arm", values, correction, false, true}; }

}  // namespace tubeplan::calibration::mistakes::joint_sign
