// Mistake: readings repeat the joints of another reading, because they were logged too early or copied from the row
// above, or repeat its position, because the tracker stood still. Either may happen to a single reading or to several
// consecutive ones.
#pragma once

#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns mistakes for readings whose joints, or whose measured position, are exactly those of another reading, if the
/// prediction of `found`, the model of a robust fit, is far from this reading but close to the other one.
[[nodiscard]] std::vector<MeasurementCheck> staleReadings(const CheckedReadings& checked, const PlacedArm& found);

}  // namespace tubeplan::calibration
