// An identification as JSON and as a table for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/readers/units.hpp"
#include "calibration/identification.hpp"

namespace tubeplan::app {

/// The unit of a free number: a slide's offset is a length although its quantity says angle.
[[nodiscard]] Dimension dimensionOf(const calibration::Unknown& unknown, const deflection::Arm& arm);

/// `readings` are those that were given, for naming outliers.
[[nodiscard]] nlohmann::json identificationJson(const calibration::Identification& result,
                                                const std::vector<calibration::Measurement>& readings,
                                                const Units& units);

[[nodiscard]] std::string identificationText(const calibration::Identification& result,
                                             const std::vector<calibration::Measurement>& readings, const Units& units);

}  // namespace tubeplan::app
