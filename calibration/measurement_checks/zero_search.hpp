// The zeros of joints that a mistake has elsewhere, as the readings have them best.
#pragma once

#include <optional>

#include "calibration/measurement_checks/joined_mistakes.hpp"

namespace tubeplan::calibration {

/// Returns the mends with their zeros found from the values tried; nothing where one is no mistake. The first joint's
/// zero and a base that is not known are one for the readings: it is looked for with the base where it nominally is.
[[nodiscard]] std::optional<JoinedMends> withZerosFound(const MistakeTrials& trials, JoinedMends parts);

}  // namespace tubeplan::calibration
