// Error of each of several models as JSON and as text.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/studies/model/model_comparison.hpp"

namespace tubeplan::app {

/// Returns the comparison of models on the same readings; `set_aside` counts the others.
[[nodiscard]] nlohmann::json modelComparisonJson(const std::vector<ModelComparisonRow>& comparison,
                                                 std::size_t set_aside, const Units& units);

/// Returns one sentence on the model that predicts held-out readings best, and its error compared with the noise.
[[nodiscard]] std::string modelComparisonSentence(const std::vector<ModelComparisonRow>& comparison,
                                                  const Units& units);

/// Returns the comparison in words, from its JSON: errors with a bar each, then the steps of the tool, if present.
[[nodiscard]] std::string modelComparisonText(nlohmann::json figures);

}  // namespace tubeplan::app
