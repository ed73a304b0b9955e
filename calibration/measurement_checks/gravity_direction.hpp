// Gravity left in another direction than it has in the readings' world: an arm on the ceiling, on a wall, or on a
// pedestal that leans.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_search.hpp"

namespace tubeplan::calibration {

/// Returns a mistake where readings fit with gravity in a direction that is fitted, to a few tenths of a degree, and do
/// not as it is; nothing where they do not, as of an arm that does not give, or where other directions fit as well. A
/// tilt below 26 deg is left to the diagnosis (`gravity-tilt`). It is the cell's file that is to be mended.
[[nodiscard]] std::optional<FoundMistake> gravityElsewhere(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
