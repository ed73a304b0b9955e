// Selection of the combinations to be fitted: a mistake of the whole table, together with rows that are shifted from a
// measurement on.
#pragma once

#include <vector>

#include "calibration/measurement_checks/joined_mistakes.hpp"

namespace tubeplan::calibration {

/// Returns mistakes that correct the first or the last measurements, each combined with the shift of rows that is found
/// once it is corrected. The first measurement of a shift cannot be found while another mistake hides it. Empty if too
/// few measurements state a position.
[[nodiscard]] std::vector<JoinedCorrections> likelyRowShifts(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
