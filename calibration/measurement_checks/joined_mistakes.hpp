// Several mistakes at once: a quick comparison selects, from all pairs of mistakes and all sets of joints with reversed
// signs, the combinations that are worth a fit.
#pragma once

#include <vector>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Corrections of one hypothesis, in the order in which they are applied.
using JoinedMends = std::vector<Mend>;

/// Returns the combinations of corrections that bring the readings closest to the rigid drawing (quick_alignment.hpp),
/// closest first: pairs of mistakes and sets of joint signs, orders or scales. Each correction of a pair brings the
/// readings closer than the other alone. Empty if too few readings state a position.
[[nodiscard]] std::vector<JoinedMends> likelyTogether(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
