// Duplicate rows of readings.
#pragma once

#include <optional>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns a remark on readings with the same values as an earlier reading; nullopt if there are none.
[[nodiscard]] std::optional<MeasurementCheck> duplicates(const CheckedReadings& checked);

/// Removes readings that are certainly copies of an earlier reading: all values are equal, and the coordinates have so
/// many digits that noise would make two separate readings differ. If copies were counted, the noise would appear too
/// small. Returns nullopt if there are no copies.
std::optional<MeasurementCheck> takeCopiesOut(CheckedReadings& checked);

}  // namespace tubeplan::calibration
