// Detection and removal of duplicate measurements.
#pragma once

#include <optional>

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

/// Returns a remark that lists the measurements with exactly the same values as an earlier measurement; nullopt if
/// there are none.
[[nodiscard]] std::optional<MeasurementCheck> duplicates(const CheckedMeasurements& checked);

/// Removes copies of earlier measurements and returns a remark on them; nullopt if there are none. A measurement is a
/// copy if all of its values are equal and its coordinates have so many digits that noise would make two separate
/// measurements differ. Copies would make the noise appear too small.
std::optional<MeasurementCheck> takeCopiesOut(CheckedMeasurements& checked);

}  // namespace tubeplan::calibration
