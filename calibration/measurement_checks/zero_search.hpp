// Fit of the joint zeros that a mistake displaces.
#pragma once

#include <optional>

#include "calibration/measurement_checks/joined_mistakes.hpp"

namespace tubeplan::calibration {

/// Returns the corrections with zeros fitted from the tried values; nothing if one is no mistake. The first joint's
/// zero and an unknown base have the same effect on the readings, so this zero is fitted with the base at its nominal
/// place.
[[nodiscard]] std::optional<JoinedMends> withZerosFound(const MistakeTrials& trials, JoinedMends parts);

}  // namespace tubeplan::calibration
