// Calibration of the base from touched holes: from a cell and its touches to the base and the figures.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::app {

struct CalibrationOutcome {
  calibration::BaseCalibration calibration;
  std::optional<ModelError> model_error;  ///< model error estimated with the base
  std::vector<calibration::Measurement> touches;
  nlohmann::json figures;  ///< JSON of `tubeplan calibrate --json`
};

/// Calibrates the base. `file` is the source of the touches, for messages. Throws InputError for too few touches, or
/// holes that do not place a base.
[[nodiscard]] CalibrationOutcome calibrateCell(const Cell& cell, const std::vector<calibration::Measurement>& touches,
                                               const std::string& file);

/// Returns the cell's text with the base and the model's error that were found, to be written at `out`.
[[nodiscard]] std::string calibratedCellText(const Cell& cell, const CalibrationOutcome& outcome,
                                             const std::string& out);

}  // namespace tubeplan::app
