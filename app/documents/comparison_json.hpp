// Comparison of model and readings as JSON and as a short text.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/patterns/comparison.hpp"

namespace tubeplan::app {

/// Sign convention of the errors, as `errors` of a comparison's document.
inline constexpr const char* kErrorsAre = "measured less predicted";

/// Returns the comparison in one plain sentence.
[[nodiscard]] std::string comparisonSentence(const calibration::Comparison& result, const Units& units);

/// Returns the comparison's document. `readings` are those compared; `set_aside` counts the others.
[[nodiscard]] nlohmann::json comparisonJson(const calibration::Comparison& result,
                                            const std::vector<calibration::Measurement>& readings,
                                            std::size_t set_aside, const Units& units);

/// Returns the comparison in words, from its JSON.
[[nodiscard]] std::string comparisonText(const nlohmann::json& figures);

}  // namespace tubeplan::app
