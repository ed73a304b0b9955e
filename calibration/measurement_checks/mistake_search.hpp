// Which of the ordinary mistakes explains the error of readings, or the place of a base: every form of every kind is
// tried quickly, and the best few with all that the drawing leaves open.
#pragma once

#include <optional>
#include <string>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// A mistake and the readings without it, by the drawing.
struct FoundMistake {
  MeasurementCheck check;
  Trial drawn;
};

/// The mistake that explains most, with those that explain as much; nothing where there is no error to be explained, or
/// none explains it. Unwinds where it was stopped.
[[nodiscard]] std::optional<FoundMistake> findMistake(const MistakeTrials& trials);

/// How far the base is from its nominal place: "12 in (8.0 pitches) and 3 deg".
[[nodiscard]] std::string baseText(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
