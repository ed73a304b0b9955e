// Results of a base calibration, as JSON and as short text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::app {

/// Returns the JSON of a calibration, including its verdict (base_verdict.hpp). `cell` is the cell before the
/// calibration, with the nominal base.
[[nodiscard]] nlohmann::json calibrationJson(const calibration::BaseCalibration& result, const Cell& cell);

/// Returns a text that states the base with its standard deviations, the residual of each touch, and the verdict; with
/// `in_full` also the distance checks and the remedies.
[[nodiscard]] std::string calibrationText(const calibration::BaseCalibration& result, const Cell& cell,
                                          bool in_full = true);

}  // namespace tubeplan::app
