// What a cell and its readings determine of the model, for commands that look ahead.
#pragma once

#include <string>
#include <vector>

#include "app/files/cell_reader.hpp"
#include "app/files/reading_input.hpp"
#include "calibration/estimation/estimate.hpp"

namespace tubeplan::app {

/// The readings of a measurement file with a sigma each; none for an empty name. `sigma` [m] stands in where the file
/// states none; 0: InputError then, unless it follows from the cell's tool.
/// `assume` as in MeasurementOptions.
[[nodiscard]] ReadingsWithChecks readingsMade(const std::string& file, Cell& cell, double sigma,
                                              const std::vector<std::string>& assume = {});

/// What the readings determine of the free numbers. `where` names what they were asked by, for the InputError about a
/// name that is no number of the arm.
[[nodiscard]] calibration::Estimate estimateOf(const Cell& cell, const std::vector<calibration::Measurement>& readings,
                                               const calibration::FreeChoice& free, const std::string& where,
                                               const calibration::DoubtBeside& doubt = {});

/// The cell with arm and base as known.
[[nodiscard]] Cell cellAsEstimated(Cell cell, const calibration::Estimate& estimate);

}  // namespace tubeplan::app
