// A base calibration as JSON and as a few lines for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::app {

/// With the verdict on it (base_verdict.hpp). `cell`: as it was before, its base the nominal one.
[[nodiscard]] nlohmann::json calibrationJson(const calibration::BaseCalibration& result, const Cell& cell);

/// Base, its sigmas, residual of each touch and the verdict; in full also the distance checks and what to do.
[[nodiscard]] std::string calibrationText(const calibration::BaseCalibration& result, const Cell& cell,
                                          bool in_full = true);

}  // namespace tubeplan::app
