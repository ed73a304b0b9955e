// Mistake of readings with the joints of another reading, logged too early or copied from the row above, or with the
// place of another one, from a tracker that stood still: single readings, and runs.
#pragma once

#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns checks of readings whose joint columns, or whose measured place, equal those of another reading exactly.
/// Their measured values are far from an arm at these joints, while those of the other reading are near. `found` is the
/// model of a robust fit.
[[nodiscard]] std::vector<MeasurementCheck> staleReadings(const CheckedReadings& checked, const PlacedArm& found);

}  // namespace tubeplan::calibration
