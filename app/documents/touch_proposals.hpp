// Proposed measurements as JSON, as text and as rows of a run sheet.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/documents/touch_outcome.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json proposalsJson(const TouchOutcome& outcome);

[[nodiscard]] std::string proposalsText(const TouchOutcome& outcome);

/// Returns all proposed measurements with their names: touches for the base, then measurements for the parameters.
[[nodiscard]] std::vector<calibration::ProposedMeasurement> runSheetOf(const TouchOutcome& outcome);

}  // namespace tubeplan::app
