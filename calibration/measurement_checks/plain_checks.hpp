// Checks of readings without a fit: joints that look like radians, loads beyond the arm's own weight, fewer numbers
// than are free, missing columns.
#pragma once

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

[[nodiscard]] std::vector<MissingColumn> missingColumns(const std::vector<Measurement>& readings);

/// Returns the checks without those of a kind that is suspected already.
[[nodiscard]] std::vector<MeasurementCheck> plainChecks(const CheckedReadings& checked,
                                                        const std::vector<MeasurementCheck>& suspected);

/// Returns a check of readings whose place is farther from the fitted base than the arm reaches.
[[nodiscard]] std::optional<MeasurementCheck> placesOutOfReach(const CheckedReadings& checked, const PlacedArm& found);

/// Returns one check for each touch that names one hole but lies at another, by the fitted model.
[[nodiscard]] std::vector<MeasurementCheck> mistakenHoles(const CheckedReadings& checked, const PlacedArm& found);

}  // namespace tubeplan::calibration
