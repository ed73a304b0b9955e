// Columns that the user must fill in for a proposed measurement, for pages and reports.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/measurements/measurements_writer.hpp"

namespace tubeplan::app {

/// Returns {columns, least, optional}, the members of FillIn.
[[nodiscard]] nlohmann::json fillInJson(const FillIn& fill);

/// Returns the instruction for a run sheet, such as "fill in x_in, y_in, z_in".
[[nodiscard]] std::string fillInText(const std::vector<calibration::ProposedMeasurement>& sheet,
                                     const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
