// What every fit of a cell's model to readings starts from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// What the cell sets free: its `identify`, and the base where that is not known.
[[nodiscard]] calibration::FreeChoice freeNumbersOf(const CellModel& cell);

/// The cell's arm with a base pose for every set-up of the readings.
[[nodiscard]] calibration::PlacedArm startOf(const CellModel& cell,
                                             const std::vector<calibration::Measurement>& readings);

/// The same, a base that the cell does not place standing where the readings have it.
[[nodiscard]] calibration::PlacedArm placedWhereRead(const CellModel& cell,
                                                     const std::vector<calibration::Measurement>& readings);

}  // namespace tubeplan::app
