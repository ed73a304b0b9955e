// Present knowledge of the model from a cell and its readings, for commands that plan ahead.
#pragma once

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/measurements/reading_input.hpp"
#include "calibration/estimation/estimate.hpp"

namespace tubeplan::app {

/// Returns the readings of a measurement file with a sigma each; none for an empty name. `sigma` [m] is used if the
/// file states none; 0: InputError then, unless it follows from the cell's tool. `assume` as in MeasurementOptions.
[[nodiscard]] ReadingsWithChecks readingsMade(const std::string& file, Cell& cell, double sigma,
                                              const std::vector<std::string>& assume = {});

/// Returns the information of the readings on the free numbers. `where` names the source of the request, for the
/// InputError about a name that is no number of the arm.
[[nodiscard]] calibration::Estimate estimateOf(const Cell& cell, const std::vector<calibration::Measurement>& readings,
                                               const calibration::FreeChoice& free, const std::string& where,
                                               const calibration::DoubtBeside& doubt = {});

/// Throws the InputError for a name that cannot be freed.
[[noreturn]] void refuseName(const std::string& where, const calibration::FreeProblem& problem,
                             const deflection::Arm& arm);

/// Returns the cell with the estimated arm and base.
[[nodiscard]] Cell cellAsEstimated(Cell cell, const calibration::Estimate& estimate);

}  // namespace tubeplan::app
