// Duplicate rows of readings.
#pragma once

#include <optional>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns a remark on readings with the same values as an earlier reading; nullopt if there are none.
[[nodiscard]] std::optional<MeasurementCheck> duplicates(const CheckedReadings& checked);

/// Removes readings that are certainly copies of an earlier reading. All values are then equal, and the coordinates
/// have so many digits that two separate readings would differ by noise. If counted twice, copies would suggest too
/// small a noise. Returns nullopt if there are no copies.
std::optional<MeasurementCheck> takeCopiesOut(CheckedReadings& checked);

}  // namespace tubeplan::calibration
