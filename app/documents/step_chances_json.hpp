// Probabilities that 0, 1, ... tool steps enter, as JSON and as text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "app/studies/positioning/step_chances.hpp"

namespace tubeplan::app {

/// Returns {counted: [...], left_out: [...], model_error: {source, value, range}, expected_counts}, or {reason} if
/// there are no probabilities.
[[nodiscard]] nlohmann::json stepChancesJson(const StepChances& chances, const Units& units);

/// Returns lines such as "probabilities of steps count the encoders, the base pose, ...", or the reason if there are no
/// probabilities.
[[nodiscard]] std::string stepChancesText(const StepChances& chances, const Units& units);

/// Returns the model error as {sigma, degrees_of_freedom, from} in file units.
[[nodiscard]] nlohmann::json modelErrorJson(const ModelError& error, const Units& units);

}  // namespace tubeplan::app
