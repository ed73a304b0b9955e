// The error of one model after another as JSON and as text.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/studies/model/model_comparison.hpp"

namespace tubeplan::app {

/// All models are judged on the same readings; so many others were set aside.
[[nodiscard]] nlohmann::json modelComparisonJson(const std::vector<ModelComparisonRow>& comparison,
                                                 std::size_t set_aside, const Units& units);

/// Which model predicts held-out readings best, and how near it comes to the noise, in one sentence.
[[nodiscard]] std::string modelComparisonSentence(const std::vector<ModelComparisonRow>& comparison,
                                                  const Units& units);

/// In words, from its JSON: errors with a bar each; below, the steps of the tool, where they are there.
[[nodiscard]] std::string modelComparisonText(nlohmann::json figures);

}  // namespace tubeplan::app
