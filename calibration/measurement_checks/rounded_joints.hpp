// Mistake of rounded joint readings, as copied from a pendant's display.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Returns a remark if revolute joints read whole multiples of a round angle, each with its own. Their rounding must
/// move the tip by more than the readings' noise and by about the size of the errors. Returns nothing otherwise, since
/// postures may be both round and exact.
[[nodiscard]] std::optional<MeasurementCheck> roundedJoints(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
