// Mistakes in the transfer of Denavit-Hartenberg numbers into the arm's file: a standard table under the keys of the
// modified one, or a twist with the reversed sign.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Returns a mistake if the readings are far off with the arm's rows but fit if these are read as standard rows.
/// Returns nothing otherwise, or if the rows are standard already. The correction belongs into the arm's file.
[[nodiscard]] std::optional<MeasurementCheck> standardRows(const MistakeTrials& trials);

/// Returns a mistake if the readings fit with the twist of one row, or of all rows, reversed in sign: the best one of
/// these.
[[nodiscard]] std::optional<MeasurementCheck> negatedTwists(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
