// Search for several simultaneous mistakes. From all pairs of mistakes and all sets of joints with reversed signs, a
// quick comparison selects the combinations to be fitted.
#pragma once

#include <vector>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Corrections of one hypothesis, in the order in which they are applied.
using JoinedCorrections = std::vector<Correction>;

/// Returns the combinations of corrections that bring the measurements closest to the rigid arm as drawn
/// (quick_alignment.hpp), closest first: pairs of mistakes and sets of joint signs, orders or scales. The two
/// corrections of a pair together bring the measurements closer than either alone. Empty if too few measurements state
/// a position.
[[nodiscard]] std::vector<JoinedCorrections> likelyTogether(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
