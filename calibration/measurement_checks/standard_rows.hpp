// Whether the arm's file has standard Denavit-Hartenberg numbers under the keys of the modified ones.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Returns a mistake where readings that are far off by the arm's rows as they are fit them as standard rows; nothing
/// where they do not, or where the rows are standard already. It is the arm's file that is to be mended.
[[nodiscard]] std::optional<MeasurementCheck> standardRows(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
