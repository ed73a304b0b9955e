// Mistake: consecutive readings are in another unit than their columns state, since one file was appended to another or
// a display was switched in between.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::part_in_unit {

/// Returns the kind of mistake for coordinates and distances in another unit.
[[nodiscard]] MistakeKind coordinates();
/// Returns the kind of mistake for joint readings in another unit.
[[nodiscard]] MistakeKind angles();

}  // namespace tubeplan::calibration::mistakes::part_in_unit
