// Mistake of a run of readings in another unit than stated by their columns: one file appended to another, or a display
// switched in between.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::part_in_unit {

/// Returns the mistake for coordinates.
[[nodiscard]] MistakeKind coordinates();
/// Returns the mistake for joint readings.
[[nodiscard]] MistakeKind angles();

}  // namespace tubeplan::calibration::mistakes::part_in_unit
