// Search for the common mistake that explains the error of readings, or the place of a base: every form of every kind
// is tried quickly, and the best few with all that the drawing leaves open.
#pragma once

#include <optional>
#include <string>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Mistake, with the fit of the corrected readings by the drawing.
struct FoundMistake {
  MeasurementCheck check;
  Trial drawn;
};

/// Returns the mistake that explains most, with those that explain as much; nothing if there is no error to explain, or
/// none explains it. Throws WorkStopped on a request to stop.
[[nodiscard]] std::optional<FoundMistake> findMistake(const MistakeTrials& trials);

/// Returns the distance of the base from its nominal place: "12 in (8.0 pitches) and 3 deg".
[[nodiscard]] std::string baseText(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
