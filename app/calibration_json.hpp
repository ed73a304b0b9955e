// A base calibration as JSON and as a few lines for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/readers/units.hpp"
#include "calibration/base_calibration.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json calibrationJson(const calibration::BaseCalibration& result, const Units& units);

/// Base, its sigmas, residual of each touch and the distance checks.
[[nodiscard]] std::string calibrationText(const calibration::BaseCalibration& result, const Units& units);

}  // namespace tubeplan::app
