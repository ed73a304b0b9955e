// Estimate of a cell's model from the measurements taken so far, for commands that plan further measurements.
#pragma once

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "calibration/estimation/estimate.hpp"

namespace tubeplan::app {

/// Returns the measurements of a measurement file, each with a standard deviation (sigma); none if the file name is
/// empty. `sigma` [m] applies to measurements that state none; if it is 0, their sigma is derived from the cell's tool.
/// Throws InputError if there is no tool either. `assume` is as in MeasurementOptions.
[[nodiscard]] MeasurementsWithChecks measurementsMade(const std::string& file, Cell& cell, double sigma,
                                                      const std::vector<std::string>& assume = {});

/// Returns the estimate of the free parameters from the measurements, with its Fisher information. Throws InputError
/// for a name that is not a parameter of the arm; `where` names the source of the name.
[[nodiscard]] calibration::Estimate estimateOf(const Cell& cell,
                                               const std::vector<calibration::Measurement>& measurements,
                                               const calibration::FreeChoice& free, const std::string& where,
                                               const calibration::AdditionalUncertainty& additional = {});

/// Throws InputError for a name that cannot be freed, with a suggestion of a similar name if there is one.
[[noreturn]] void refuseName(const std::string& where, const calibration::FreeProblem& problem,
                             const deflection::Arm& arm);

/// Returns the cell with the estimated arm, and with the base pose of the last set-up.
[[nodiscard]] Cell cellAsEstimated(Cell cell, const calibration::Estimate& estimate);

}  // namespace tubeplan::app
