// Probabilities of steps as JSON and in words.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "app/studies/positioning/step_chances.hpp"

namespace tubeplan::app {

/// Returns {reason} or {counted: [...], left_out: [...], model_error: {source, value, range}, expected_counts}.
[[nodiscard]] nlohmann::json stepChancesJson(const StepChances& chances, const Units& units);

/// Returns "counting the joints' readings, the base's place and the model's own error, ...", or the reason for no
/// chances.
[[nodiscard]] std::string stepChancesText(const StepChances& chances, const Units& units);

/// Returns {sigma, degrees_of_freedom, from}.
[[nodiscard]] nlohmann::json modelErrorJson(const ModelError& error, const Units& units);

}  // namespace tubeplan::app
