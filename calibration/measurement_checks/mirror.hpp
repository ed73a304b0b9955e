// Mistake: the sign of one coordinate axis is reversed.
#pragma once

#include "calibration/measurement_checks/axes.hpp"

namespace tubeplan::calibration::mistakes::mirror {

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  return axes::areWritten(checked) ? std::vector<std::string>{"x", "y", "z"} : std::vector<std::string>{};
}

inline std::optional<Correction> correction(const CheckedMeasurements&, const std::string& value) {
  if (value != "x" && value != "y" && value != "z") return std::nullopt;
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  signs[value[0] - 'x'] = -1;
  Correction correction{"mirror", value, "the coordinates are mirrored: " + value + " has the other sign"};
  correction.change = [signs](std::vector<Measurement>& measurements) { axes::turn(signs.asDiagonal(), measurements); };
  return correction;
}

inline MistakeKind kind() { return {"mirror", "AXIS", "x, y or z", values, correction}; }

}  // namespace tubeplan::calibration::mistakes::mirror
