// The error of one model after another as JSON and as text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/files/units.hpp"
#include "app/studies/model/model_comparison.hpp"

namespace tubeplan::app {

[[nodiscard]] nlohmann::json modelComparisonJson(const std::vector<ModelComparisonRow>& comparison, const Units& units);

/// Errors with a bar each; below, the steps of the tool, where they are there.
[[nodiscard]] std::string modelComparisonText(const std::vector<ModelComparisonRow>& comparison, const Units& units);

}  // namespace tubeplan::app
