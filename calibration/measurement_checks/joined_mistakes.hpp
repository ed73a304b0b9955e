// Several mistakes at once: a quick choice among all pairs, and all sets of joints with a reversed sign, of those worth
// a fit.
#pragma once

#include <vector>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Corrections of one hypothesis, in the order in which they are applied.
using JoinedMends = std::vector<Mend>;

/// Returns the pairs and sets of signs with the readings nearest to the rigid drawing (quick_alignment.hpp), nearest
/// first. Each of their corrections brings the readings nearer than the others alone. Empty if too few readings state a
/// place.
[[nodiscard]] std::vector<JoinedMends> likelyTogether(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
