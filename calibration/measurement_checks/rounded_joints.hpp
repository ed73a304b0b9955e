// Mistake: joint readings are rounded, as if copied from a pendant's display.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Returns a remark if the readings of revolute joints are whole multiples of a round angle, which may differ between
/// joints. The rounding must move the tip by more than the readings' noise and by about the size of the errors. Returns
/// nullopt otherwise, since exact readings may be round, too.
[[nodiscard]] std::optional<MeasurementCheck> roundedJoints(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
