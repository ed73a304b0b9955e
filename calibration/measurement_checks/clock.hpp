// Mistake of a clock that was reset or misread during the readings: times go back, or forward by whole hours or months.
// Effects that follow time (drift, slip) would be fitted to wrong times.
#pragma once

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns remarks on readings whose time does not follow that of the reading before, with the difference, and on
/// single readings with a wrong time. Empty if rows are not ordered by time, or if a gap may be a pause.
[[nodiscard]] std::vector<MeasurementCheck> clockJumps(const CheckedReadings& checked);

namespace mistakes::clock {

/// Returns the mistake of times that are late or early by some seconds from a reading on; clockJumps() finds the
/// reading.
[[nodiscard]] MistakeKind kind();

}  // namespace mistakes::clock

}  // namespace tubeplan::calibration
