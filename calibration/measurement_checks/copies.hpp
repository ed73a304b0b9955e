// Duplicate rows of readings.
#pragma once

#include <optional>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns a remark on readings with the same numbers as an earlier one; nothing if there are none.
[[nodiscard]] std::optional<MeasurementCheck> duplicates(const CheckedReadings& checked);

/// Removes readings that are certainly copies of an earlier one: all numbers are equal, and the coordinates have so
/// many digits that two readings would differ by noise. Counted twice they would suggest a noise that is too small.
/// Returns nothing if there are none.
std::optional<MeasurementCheck> takeCopiesOut(CheckedReadings& checked);

}  // namespace tubeplan::calibration
