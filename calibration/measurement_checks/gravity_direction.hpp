// Gravity left along another axis than it has in the readings' world: an arm on the ceiling or on a wall.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Returns a mistake where readings fit with gravity along another axis of the world, and do not as it is; nothing
/// where they do not, as of an arm that does not give. It is the cell's file that is to be mended.
[[nodiscard]] std::optional<MeasurementCheck> gravityElsewhere(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
