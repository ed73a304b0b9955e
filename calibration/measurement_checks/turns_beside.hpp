// Mistakes of what the turns of a measured frame say, beside others that places show: which are worth a fit.
#pragma once

#include <vector>

#include "calibration/measurement_checks/joined_mistakes.hpp"

namespace tubeplan::calibration {

/// Returns the mistake that the places of pose readings show by themselves with each form of a mistake of their turns
/// beside it, and two mistakes of the turns with none; none where too few readings state both.
[[nodiscard]] std::vector<JoinedMends> likelyBesideTurns(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
