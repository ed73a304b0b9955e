// The common start of every fit of a cell's model to readings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// Returns the free numbers of the cell: its `identify`, and the base if that is unknown.
[[nodiscard]] calibration::FreeChoice freeNumbersOf(const CellModel& cell);

/// Returns the cell's arm with a base pose for every set-up of the readings.
[[nodiscard]] calibration::PlacedArm startOf(const CellModel& cell,
                                             const std::vector<calibration::Measurement>& readings);

/// Returns the placed arm, with bases that the cell does not place aligned with the readings.
[[nodiscard]] calibration::PlacedArm placedWhereRead(const CellModel& cell,
                                                     const std::vector<calibration::Measurement>& readings);

}  // namespace tubeplan::app
