// Mistake of gravity with another direction than in the readings' world: an arm on the ceiling, on a wall, or on a
// tilted pedestal.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_search.hpp"

namespace tubeplan::calibration {

/// Returns a mistake if the readings fit with a fitted direction of gravity, to a few tenths of a degree, and not with
/// the stated one. Returns nothing if they do not fit, as for an arm without compliance, or if other directions fit as
/// well. A tilt below 26 deg is left to the diagnosis (`gravity-tilt`). The correction belongs into the cell's file.
[[nodiscard]] std::optional<FoundMistake> gravityElsewhere(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
