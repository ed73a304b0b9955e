// What is seen in readings without a fit: joints that look like radians, loads beyond the arm's own weight, too few
// numbers for those that are free, columns that are missing.
#pragma once

#include "calibration/measurement_checks/measurement_checks.hpp"

namespace tubeplan::calibration {

[[nodiscard]] std::vector<MissingColumn> missingColumns(const std::vector<Measurement>& readings);

/// Without those of a kind that is suspected already.
[[nodiscard]] std::vector<MeasurementCheck> plainChecks(const CheckedReadings& checked,
                                                        const std::vector<MeasurementCheck>& suspected);

/// Readings whose place is farther from the base, as it was found, than the arm reaches.
[[nodiscard]] std::optional<MeasurementCheck> placesOutOfReach(const CheckedReadings& checked, const PlacedArm& found);

/// Touches that name one hole and lie at another, by the model as it was found; one check for each.
[[nodiscard]] std::vector<MeasurementCheck> mistakenHoles(const CheckedReadings& checked, const PlacedArm& found);

}  // namespace tubeplan::calibration
