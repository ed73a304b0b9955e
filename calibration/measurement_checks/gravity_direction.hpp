// Mistake: in the world frame of the measurements, gravity does not have the direction that the cell states. For
// example, the arm hangs from a ceiling or a wall, or stands on a tilted pedestal.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_search.hpp"

namespace tubeplan::calibration {

/// Returns a mistake if the model fits the measurements only with a direction of gravity other than the stated one.
/// This direction is found to within a few tenths of a degree. Returns nullopt if no direction fits, or if several fit
/// equally well, as for an arm without compliance. A tilt below 26 deg is left to the diagnosis (effect
/// `gravity-tilt`). The user must correct the cell's file.
[[nodiscard]] std::optional<FoundMistake> wrongGravityDirection(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
