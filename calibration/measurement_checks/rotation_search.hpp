// Selection of the combinations to be fitted: mistakes in the rotations of a measured frame, together with mistakes
// that positions reveal.
#pragma once

#include <vector>

#include "calibration/measurement_checks/joined_mistakes.hpp"

namespace tubeplan::calibration {

/// Returns the mistake that the positions of pose measurements alone reveal, combined with each value of a mistake in
/// their rotations. If positions reveal no mistake, returns pairs of mistakes in the rotations. Empty if too few
/// measurements state both a position and a rotation.
[[nodiscard]] std::vector<JoinedCorrections> likelyRotationMistakes(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
