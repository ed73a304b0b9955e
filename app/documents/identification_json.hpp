// An identification as JSON and as a table for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/files/units.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// `readings` are those that were given, for naming outliers.
[[nodiscard]] nlohmann::json identificationJson(const calibration::Identification& result,
                                                const std::vector<calibration::Measurement>& readings,
                                                const Units& units);

[[nodiscard]] std::string identificationText(const calibration::Identification& result,
                                             const std::vector<calibration::Measurement>& readings, const Units& units);

}  // namespace tubeplan::app
