// Several ordinary mistakes at once: which of all pairs, and of all sets of joints with another sign, are worth a fit.
#pragma once

#include <vector>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// The mends of one hypothesis, in the order in which they are made.
using JoinedMends = std::vector<Mend>;

/// The pairs and sets of signs by which the readings are nearest to the rigid drawing (quick_alignment.hpp), the
/// nearest first. Each of their mends brings them nearer than the others do alone. None where too few readings state a
/// place.
[[nodiscard]] std::vector<JoinedMends> likelyTogether(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
