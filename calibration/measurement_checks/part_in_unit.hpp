// A run of readings in another unit than their columns say: one file appended to another, or a display switched over in
// between.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::part_in_unit {

/// Of the coordinates.
[[nodiscard]] MistakeKind coordinates();
/// Of the joint readings.
[[nodiscard]] MistakeKind angles();

}  // namespace tubeplan::calibration::mistakes::part_in_unit
