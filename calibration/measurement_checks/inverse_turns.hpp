// Mistake: the rotations are inverse. They state the world in the tool frame instead of the tool frame in the world, as
// the transposed matrix does.
#pragma once

#include <algorithm>

#include "calibration/measurement_checks/mistake.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration::mistakes::inverse_turns {

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  return std::ranges::any_of(checked.measurements, statesFrame) ? std::vector<std::string>{"inverse"}
                                                                : std::vector<std::string>{};
}

inline std::optional<Correction> correction(const CheckedMeasurements&, const std::string& value) {
  if (value != "inverse") return std::nullopt;
  Correction correction{"turns", value,
                        "the turns are inverse: of the world in the tool's frame, not of the tool in the world"};
  correction.change = toEach([](Measurement& measurement) {
    if (statesFrame(measurement))
      measurement.kind_values = deflection::fixedAnglesOf(
          Eigen::Matrix3d(deflection::rotationFromFixedAngles<double>(measurement.kind_values).transpose()));
  });
  return correction;
}

inline MistakeKind kind() {
  return {.name = "turns",
          .value = "inverse",
          .expected = "inverse: the turns are of the world in the tool's frame",
          .values = values,
          .correction = correction,
          .values_with_others = noValues,
          .is_of_turns = true};
}

}  // namespace tubeplan::calibration::mistakes::inverse_turns
