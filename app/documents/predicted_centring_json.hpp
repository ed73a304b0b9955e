// Predicted centring error, as JSON and as text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "app/studies/positioning/predicted_centring.hpp"

namespace tubeplan::app {

/// Returns {median, p95, worst: {value, hole}, band: {median, p95, worst: [low, high]}, encoder_noise: {median, p95,
/// worst}, unit, holes, ...}, or only {reason} if there is no prediction.
[[nodiscard]] nlohmann::json predictedCentringJson(const PredictedCentring& predicted, const Units& units);

/// Returns the text of the prediction, generated from the JSON of predictedCentringJson().
[[nodiscard]] std::string predictedCentringText(const nlohmann::json& predicted);

}  // namespace tubeplan::app
