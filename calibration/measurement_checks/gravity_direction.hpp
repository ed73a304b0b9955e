// Mistake: gravity has another direction in the readings' world than the cell states. The arm may hang from a ceiling
// or a wall, or stand on a tilted pedestal.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_search.hpp"

namespace tubeplan::calibration {

/// Returns a mistake if the readings fit with a fitted direction of gravity, accurate to a few tenths of a degree, and
/// do not fit with the stated direction. Returns nullopt if the readings fit with no direction, as for an arm without
/// compliance, or if other directions fit equally well. A tilt below 26 deg is left to the diagnosis (`gravity-tilt`).
/// The correction has to be made in the cell's file.
[[nodiscard]] std::optional<FoundMistake> gravityElsewhere(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
