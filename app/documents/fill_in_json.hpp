// What of a proposed reading is to be filled in, as pages and reports take it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/measurements/measurements_writer.hpp"

namespace tubeplan::app {

/// Returns {"columns", "least", "optional"}.
[[nodiscard]] nlohmann::json fillInJson(const FillIn& fill);

/// Returns what to do with a run sheet, in words: "fill in x_in, y_in, z_in".
[[nodiscard]] std::string fillInText(const std::vector<calibration::ProposedMeasurement>& sheet,
                                     const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
