// A clock that was set, or read wrong, while readings were taken: times go back, or on by whole hours or months. What
// follows time (drift, slip) would be looked for along times that never were.
#pragma once

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns remarks on the readings at which the time does not follow that of the reading before, and by how much; on
/// one whose time alone is off. Nothing where rows are in no order of time, or where a gap may well be a pause.
[[nodiscard]] std::vector<MeasurementCheck> clockJumps(const CheckedReadings& checked);

namespace mistakes::clock {

/// Times that are so many seconds late or early from a reading on; clockJumps() sees where.
[[nodiscard]] MistakeKind kind();

}  // namespace mistakes::clock

}  // namespace tubeplan::calibration
