// Proposed readings as JSON, as text for people and as a table to be filled in.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/documents/touch_outcome.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json proposalsJson(const TouchOutcome& outcome);

[[nodiscard]] std::string proposalsText(const TouchOutcome& outcome);

/// A measurement table with the joints to go to and the coordinates left empty.
[[nodiscard]] std::string proposalsCsv(const TouchOutcome& outcome);

}  // namespace tubeplan::app
