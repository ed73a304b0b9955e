// Checks of measurements without a fit: joint readings that look like radians, loads much heavier than the arm, too few
// measured values for the free parameters, missing columns.
#pragma once

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

[[nodiscard]] std::vector<MissingColumn> missingColumns(const std::vector<Measurement>& measurements);

/// Returns the findings of the checks, except findings whose name is already among those in `suspected`.
[[nodiscard]] std::vector<MeasurementCheck> plainChecks(const CheckedMeasurements& checked,
                                                        const std::vector<MeasurementCheck>& suspected);

/// Returns a remark on measurements whose position is farther from the fitted base than the arm reaches; nullopt if
/// there are none.
[[nodiscard]] std::optional<MeasurementCheck> placesOutOfReach(const CheckedMeasurements& checked,
                                                               const PlacedArm& found);

/// Returns one remark for each touch that names one hole but, according to the fitted model, lies at another hole.
[[nodiscard]] std::vector<MeasurementCheck> mistakenHoles(const CheckedMeasurements& checked, const PlacedArm& found);

}  // namespace tubeplan::calibration
