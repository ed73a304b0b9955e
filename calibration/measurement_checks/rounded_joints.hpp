// Mistake: joint readings are rounded, as if copied from a pendant's display.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Returns a remark if the readings of revolute joints are whole multiples of a round angle, which may differ between
/// joints, and if such rounding explains the errors: it must move the tip by more than the noise and by about as much
/// as the errors. Returns nullopt otherwise, because exact readings may be round by chance.
[[nodiscard]] std::optional<MeasurementCheck> roundedJoints(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
