// Identification as JSON and as a table for people.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// Returns the identification's document. `readings` are those given to the fit, for naming outliers; `set_aside`
/// counts the others.
[[nodiscard]] nlohmann::json identificationJson(const calibration::Identification& result,
                                                const std::vector<calibration::Measurement>& readings,
                                                std::size_t set_aside, const Units& units);

/// Returns the identification in words, from its JSON.
[[nodiscard]] std::string identificationText(const nlohmann::json& figures);

}  // namespace tubeplan::app
