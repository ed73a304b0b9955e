// What every fit of a cell's model to readings starts from, and how its refusal is told.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/input_error.hpp"
#include "app/reading_input.hpp"
#include "calibration/identification.hpp"

namespace tubeplan::app {

/// What the cell sets free: its `identify`, and the base where that is not known.
[[nodiscard]] calibration::FreeChoice freeNumbersOf(const Cell& cell);

/// The cell's arm with a placing for every set-up of the readings.
[[nodiscard]] calibration::PlacedArm startOf(const Cell& cell, const std::vector<calibration::Measurement>& readings);

/// Readings that do not tell what is free, as bad input of their file.
[[nodiscard]] InputError refusalOf(const std::optional<calibration::ReadingProblem>& problem, const std::string& reason,
                                   const CellReadings& input);

}  // namespace tubeplan::app
