// Search for the common mistake that explains the measurements' error or the base's displacement. Every value of every
// kind of mistake is tried quickly; the best few are then fitted with all parameters free that the drawing leaves open.
#pragma once

#include <optional>
#include <string>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Suspected mistake, with the fit of the corrected measurements to the arm as drawn.
struct FoundMistake {
  MeasurementCheck check;
  Trial drawn;
};

/// Returns the mistake that best explains the error, with the values of `--assume` for other mistakes that explain it
/// equally well. Returns nullopt if there is no error to explain, or if no mistake explains it. Throws WorkStopped if a
/// stop is requested.
[[nodiscard]] std::optional<FoundMistake> findMistake(const MistakeTrials& trials);

/// Returns the distance of the base from its nominal place as text, such as "12 in (8.0 pitches) and 3 deg".
[[nodiscard]] std::string baseText(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
