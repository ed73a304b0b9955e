// Mistakes in the transfer of Denavit-Hartenberg parameters into the arm's file: a standard table under the keys of the
// modified convention, or a twist with reversed sign.
#pragma once

#include <optional>

#include "calibration/measurement_checks/mistake_trials.hpp"

namespace tubeplan::calibration {

/// Returns a mistake if the errors are large with the arm's rows as stated, but small if the rows are read in the
/// standard convention. Returns nullopt otherwise, or if the rows are in the standard convention already. The user must
/// correct the arm's file.
[[nodiscard]] std::optional<MeasurementCheck> standardRows(const MistakeTrials& trials);

/// Returns a mistake if the measurements fit when the sign of one row's twist, or of every row's twist, is reversed. If
/// several of these variants fit, the one with the smallest error is reported. Returns nullopt if no variant fits.
[[nodiscard]] std::optional<MeasurementCheck> negatedTwists(const MistakeTrials& trials);

}  // namespace tubeplan::calibration
