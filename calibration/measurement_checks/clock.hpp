// Mistake: a clock was reset or misread during the measurements. Signs are times that jump back, or forward by whole
// hours or by more than a month. Effects that depend on time (drift, slip) would then be fitted to wrong times.
#pragma once

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns remarks on measurements whose time jumps relative to the previous measurement, with the size of the jump,
/// and on single measurements with a wrong time. Empty if the rows are not in time order. A long gap that may be a
/// pause is not reported.
[[nodiscard]] std::vector<MeasurementCheck> clockJumps(const CheckedMeasurements& checked);

namespace mistakes::clock {

/// Returns the kind of mistake in which the times of a measurement and of all later ones are off by the same number of
/// seconds. clockJumps() finds the first such measurement.
[[nodiscard]] MistakeKind kind();

}  // namespace mistakes::clock

}  // namespace tubeplan::calibration
