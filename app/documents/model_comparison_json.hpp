// Errors of several models, as JSON and as text.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/studies/model/model_comparison.hpp"

namespace tubeplan::app {

/// Returns the JSON of a comparison of models on the same measurements; `set_aside` is the number of excluded
/// measurements.
[[nodiscard]] nlohmann::json modelComparisonJson(const std::vector<ModelComparisonRow>& comparison,
                                                 std::size_t set_aside, const Units& units);

/// Returns one sentence that names the model with the smallest held-out error, and states this error relative to the
/// noise.
[[nodiscard]] std::string modelComparisonSentence(const std::vector<ModelComparisonRow>& comparison,
                                                  const Units& units);

/// Returns the text of a comparison, generated from the JSON of modelComparisonJson(): the error of each model with a
/// bar, then the step tables if there are any.
[[nodiscard]] std::string modelComparisonText(nlohmann::json figures);

}  // namespace tubeplan::app
