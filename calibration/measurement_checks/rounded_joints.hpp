// Joint readings that were rounded, as by hand from a pendant's display.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Returns a remark where turning joints read whole multiples of a round angle, each of its own, which together moves
/// the tip by more than the readings' noise and by about as much as they are off; nothing elsewhere: postures may be
/// round and exact.
[[nodiscard]] std::optional<MeasurementCheck> roundedJoints(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
