// Comparison of a model with measurements, as JSON and as short text.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/patterns/comparison.hpp"

namespace tubeplan::app {

/// Sign convention of all errors; the JSON of a comparison states it under the key `errors`.
inline constexpr const char* kErrorsAre = "measured less predicted";

/// Returns the result of a comparison in one sentence.
[[nodiscard]] std::string comparisonSentence(const calibration::Comparison& result, const Units& units);

/// Returns the JSON of a comparison. `measurements` are the compared measurements; `set_aside` is the number of
/// excluded measurements.
[[nodiscard]] nlohmann::json comparisonJson(const calibration::Comparison& result,
                                            const std::vector<calibration::Measurement>& measurements,
                                            std::size_t set_aside, const Units& units);

/// Returns the text of a comparison, generated from the JSON of comparisonJson().
[[nodiscard]] std::string comparisonText(const nlohmann::json& figures);

}  // namespace tubeplan::app
