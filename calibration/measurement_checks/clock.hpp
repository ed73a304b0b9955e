// Mistake: a clock was reset or misread during the readings. Times jump back, or forward by whole hours or months.
// Effects that follow time (drift, slip) would then be fitted to wrong times.
#pragma once

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns remarks on readings whose time jumps relative to the previous reading, with the size of the jump, and on
/// single readings with a wrong time. Empty if the rows are not ordered by time, or if a long gap may be a pause.
[[nodiscard]] std::vector<MeasurementCheck> clockJumps(const CheckedReadings& checked);

namespace mistakes::clock {

/// Returns the mistake that times are late or early by a number of seconds, from a reading on. clockJumps() finds this
/// reading.
[[nodiscard]] MistakeKind kind();

}  // namespace mistakes::clock

}  // namespace tubeplan::calibration
