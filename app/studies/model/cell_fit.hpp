// Starting values that all fits of a cell's model to measurements share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// Returns the free parameters of the cell: the names in `identify`, and the base if it is unknown.
[[nodiscard]] calibration::FreeChoice freeNumbersOf(const CellModel& cell);

/// Returns the cell's arm with a base pose for each set-up of the measurements.
[[nodiscard]] calibration::PlacedArm startOf(const CellModel& cell,
                                             const std::vector<calibration::Measurement>& measurements);

/// Returns the cell's arm with a base pose for each set-up. Base poses that the cell does not state are aligned with
/// the measurements.
[[nodiscard]] calibration::PlacedArm placedWhereRead(const CellModel& cell,
                                                     const std::vector<calibration::Measurement>& measurements);

}  // namespace tubeplan::app
