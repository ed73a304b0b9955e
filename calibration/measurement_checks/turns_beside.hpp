// Choice of mistakes in the rotations of a measured frame, together with others that positions show, that are worth a
// fit.
#pragma once

#include <vector>

#include "calibration/measurement_checks/joined_mistakes.hpp"

namespace tubeplan::calibration {

/// Returns the mistake that the positions of pose readings show alone, combined with each form of a mistake in their
/// rotations. Without such a mistake, returns pairs of mistakes in the rotations. Empty if too few readings state both.
[[nodiscard]] std::vector<JoinedMends> likelyBesideTurns(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
