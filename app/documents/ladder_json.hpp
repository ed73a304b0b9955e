// The error of one model after another as JSON and as text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/files/units.hpp"
#include "app/studies/model/ladder.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json ladderJson(const std::vector<Rung>& rungs, const Units& units);

/// Errors with a bar each; below, the steps of the tool, where they are there.
[[nodiscard]] std::string ladderText(const std::vector<Rung>& rungs, const Units& units);

}  // namespace tubeplan::app
