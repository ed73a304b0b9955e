// Whether the arm's file has Denavit-Hartenberg numbers that were taken over wrongly: a standard table under the keys of
// the modified one, or a twist with the other sign.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Returns a mistake where readings that are far off by the arm's rows as they are fit them as standard rows; nothing
/// where they do not, or where the rows are standard already. It is the arm's file that is to be mended.
[[nodiscard]] std::optional<MeasurementCheck> standardRows(const MistakeTrials& trials);

/// Returns the same of the twist of one row, or of all rows, with the other sign: of those the one that fits best.
[[nodiscard]] std::optional<MeasurementCheck> negatedTwists(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
