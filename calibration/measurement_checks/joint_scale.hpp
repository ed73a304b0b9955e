// A joint read in encoder pulses, or in any other measure that is no unit: its readings by a number that nobody stated.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::joint_scale {

/// Joints whose readings go farther than any joint turns, by their indices.
[[nodiscard]] std::vector<int> jointsBeyondTurns(const CheckedReadings& checked);

[[nodiscard]] MistakeKind kind();

}  // namespace tubeplan::calibration::mistakes::joint_scale
