// Rows of readings that stand there twice.
#pragma once

#include <optional>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Readings all of whose numbers an earlier one has; nothing where there are none.
[[nodiscard]] std::optional<MeasurementCheck> duplicates(const CheckedReadings& checked);

/// Takes out the readings that are copies of an earlier one beyond doubt: all numbers are the same, and the coordinates
/// are written so finely against their noise that two readings would differ. Counted twice they would look like noise
/// that is too small. Nothing where there is none.
std::optional<MeasurementCheck> takeCopiesOut(CheckedReadings& checked);

}  // namespace tubeplan::calibration
