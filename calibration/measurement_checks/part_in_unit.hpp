// Mistake: a run of measurements is not in the unit that its columns state, because one file was appended to another or
// the unit of a display was switched in between.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::part_in_unit {

/// Returns the kind of mistake for runs of coordinates and distances in the wrong unit.
[[nodiscard]] MistakeKind coordinates();
/// Returns the kind of mistake for runs of joint readings in the wrong unit.
[[nodiscard]] MistakeKind angles();

}  // namespace tubeplan::calibration::mistakes::part_in_unit
