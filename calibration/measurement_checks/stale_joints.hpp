// Readings that state the joints of another, logged before the controller had its new ones or copied from the row
// above, or the place of another, of a tracker that stood still: single ones, and runs.
#pragma once

#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Names the readings whose joint columns, or whose measured place, are those of another reading, number for number,
/// and whose measured values are far from where an arm at these joints would have them, while the other's are near.
/// `found` is the model as a robust fit has it.
[[nodiscard]] std::vector<MeasurementCheck> staleReadings(const CheckedReadings& checked, const PlacedArm& found);

}  // namespace tubeplan::calibration
