// A comparison of model and readings as JSON and as a few lines for people.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/patterns/comparison.hpp"

namespace tubeplan::app {

/// `errors` of a comparison's document; they had been the other way round.
inline constexpr const char* kErrorsAre = "measured less predicted";

/// The one plain sentence of a comparison.
[[nodiscard]] std::string comparisonSentence(const calibration::Comparison& result, const Units& units);

/// `readings` are those that were compared; so many others were set aside.
[[nodiscard]] nlohmann::json comparisonJson(const calibration::Comparison& result,
                                            const std::vector<calibration::Measurement>& readings,
                                            std::size_t set_aside, const Units& units);

/// In words, from its JSON.
[[nodiscard]] std::string comparisonText(const nlohmann::json& figures);

}  // namespace tubeplan::app
