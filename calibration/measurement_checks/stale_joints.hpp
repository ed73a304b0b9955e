// Mistake: readings repeat the joints of another reading, because they were logged too early or copied from the row
// above, or repeat its position, because the tracker stood still. Both occur in single readings and in consecutive
// ones.
#pragma once

#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns mistakes for readings whose joint columns, or whose measured position, equal those of another reading
/// exactly. The arm at these joints is far from the measured values of such a reading, but close to those of the other
/// reading. `found` is the model of a robust fit.
[[nodiscard]] std::vector<MeasurementCheck> staleReadings(const CheckedReadings& checked, const PlacedArm& found);

}  // namespace tubeplan::calibration
