// Fit of the joint zeros that a suspected mistake concerns.
#pragma once

#include <optional>

#include "calibration/measurement_checks/joined_mistakes.hpp"

namespace tubeplan::calibration {

/// Returns the corrections with the zeros fitted, starting from the tried values; nullopt if a fitted zero is too small
/// to be a mistake. The zero of the first joint and an unknown base have the same effect on the measurements, so this
/// zero is fitted with the base at its nominal pose.
[[nodiscard]] std::optional<JoinedCorrections> withZerosFound(const MistakeTrials& trials, JoinedCorrections parts);

}  // namespace tubeplan::calibration
