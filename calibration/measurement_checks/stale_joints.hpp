// Mistake: measurements repeat the joints of another measurement, because they were logged too early or copied from the
// row above, or repeat its position, because the tracker stood still. Either may happen to a single measurement or to
// several consecutive ones.
#pragma once

#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns a mistake for each measurement with exactly the same joint readings, or the same measured position, as
/// another one. `found` is the model of a robust fit: its prediction must be far from the measurement itself, but close
/// to the other one.
[[nodiscard]] std::vector<MeasurementCheck> staleMeasurements(const CheckedMeasurements& checked,
                                                              const PlacedArm& found);

}  // namespace tubeplan::calibration
