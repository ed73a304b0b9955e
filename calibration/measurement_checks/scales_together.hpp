// Search for the scales of several joints that are read in encoder pulses, from the measured positions.
//
// Scales cannot be found joint by joint: as long as one scale is wrong, the correct scales of the other joints do not
// fit either. A campaign moves its joints over much of their range, so a few scales of either sign for each joint are
// tried in all combinations. The best combinations are improved joint by joint, and finally by a fit of the scales to
// the flexible arm.
#pragma once

#include <vector>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration {

/// Returns the most probable scales, best first: for each solution, one value of `joint-scale` per joint [rad per unit
/// read]. Empty if too few measurements state a position, or if there are too many joints.
[[nodiscard]] std::vector<std::vector<std::string>> likelyScales(const CheckedMeasurements& checked,
                                                                 const std::vector<int>& joints);

}  // namespace tubeplan::calibration
