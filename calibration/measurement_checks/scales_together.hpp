// Several joints read in pulses of their encoders: the scales of all of them together, by where the arm would be.
//
// Scales of one joint after another do not help: with one wrong the others look wrong too. A campaign moves its joints
// over a good part of their range, so that a few scales of each, of either sign, are worth trying in all combinations;
// the best of these are bettered joint by joint and at last by a fit of the scales with the arm's own stiffnesses.
#pragma once

#include <vector>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration {

/// Returns the likeliest scales, as values of `joint-scale` one for each of the joints [rad per what was read]; the
/// best first, none where too few readings state a place, or the joints are too many.
[[nodiscard]] std::vector<std::vector<std::string>> likelyScales(const CheckedReadings& checked,
                                                                 const std::vector<int>& joints);

}  // namespace tubeplan::calibration
