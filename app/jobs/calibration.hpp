// Calibration of the base from touched holes: a cell and its touches give the base pose and the results as JSON.
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
  /// Model error, estimated from touches that do not fit or taken from the cell; empty if there is neither.
  std::optional<ModelError> model_error;
  std::vector<calibration::Measurement> touches;
  nlohmann::json figures;  ///< output of `tubeplan calibrate --json`
};

/// Calibrates the base. `file` names the source of the touches in messages. Throws InputError if there are too few
/// touches, or if the touched holes do not determine a base pose.
[[nodiscard]] CalibrationOutcome calibrateCell(const Cell& cell, const std::vector<calibration::Measurement>& touches,
                                               const std::string& file);

/// Returns the text of the cell file with the calibrated base and model error, to be written to the path `out`.
[[nodiscard]] std::string calibratedCellText(const Cell& cell, const CalibrationOutcome& outcome,
                                             const std::string& out);

}  // namespace tubeplan::app
