// Identification as JSON and as text.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// Returns the JSON of an identification. `measurements` are all measurements that were passed to the identification;
/// `set_aside` is the number of measurements that were excluded beforehand.
[[nodiscard]] nlohmann::json identificationJson(const calibration::Identification& result,
                                                const std::vector<calibration::Measurement>& measurements,
                                                std::size_t set_aside, const Units& units);

/// Returns the text of an identification, generated from the JSON of identificationJson().
[[nodiscard]] std::string identificationText(const nlohmann::json& figures);

}  // namespace tubeplan::app
