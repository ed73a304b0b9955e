// Probabilities of steps as JSON and in words.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "app/studies/positioning/step_chances.hpp"

namespace tubeplan::app {

/// {reason} or {counted: [...], left_out: [...], model_error: {source, value, range}, expected_counts}.
[[nodiscard]] nlohmann::json stepChancesJson(const StepChances& chances, const Units& units);

/// "counting the joints' readings, the base's place and the model's own error, ..." or why there are none.
[[nodiscard]] std::string stepChancesText(const StepChances& chances, const Units& units);

/// {sigma, degrees_of_freedom, from}.
[[nodiscard]] nlohmann::json modelErrorJson(const ModelError& error, const Units& units);

}  // namespace tubeplan::app
