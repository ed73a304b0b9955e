// Detection and removal of duplicate readings.
#pragma once

#include <optional>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns a remark that lists the readings whose values all equal those of an earlier reading; nullopt if there are
/// none.
[[nodiscard]] std::optional<MeasurementCheck> duplicates(const CheckedReadings& checked);

/// Removes copies of earlier readings and returns a remark on them; nullopt if there are none. A reading is a copy if
/// all of its values are equal and its coordinates have so many digits that noise would make two separate readings
/// differ. Copies would make the noise appear too small.
std::optional<MeasurementCheck> takeCopiesOut(CheckedReadings& checked);

}  // namespace tubeplan::calibration
