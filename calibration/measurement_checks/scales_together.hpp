// Scales of several joints that are read in encoder pulses, found together from the arm's positions.
//
// Scales of one joint at a time do not help: with one wrong scale the others look wrong too. A campaign moves its
// joints over much of their range, so a few scales of either sign for each joint are tried in all combinations. The
// best ones are improved joint by joint, and finally by a fit of the scales with the arm's own stiffnesses.
#pragma once

#include <vector>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration {

/// Returns the likeliest scales, as one value of `joint-scale` for each of the joints [rad per unit read], best first.
/// Empty if too few readings state a place, or if there are too many joints.
[[nodiscard]] std::vector<std::vector<std::string>> likelyScales(const CheckedReadings& checked,
                                                                 const std::vector<int>& joints);

}  // namespace tubeplan::calibration
