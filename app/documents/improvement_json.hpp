// How a model was improved step by step, as JSON and in words.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/studies/model/improvement.hpp"

namespace tubeplan::app {

/// "adequate", "nothing-sure", ...
[[nodiscard]] const char* nameOf(ImprovementEnd end);

/// Why a cause was added, or why the loop ends there.
[[nodiscard]] std::string reasonText(const ImprovementStep& step, const Units& units);

/// As `tubeplan improve --json` writes it.
[[nodiscard]] nlohmann::json improvementJson(const Improvement& result,
                                             const std::vector<calibration::Measurement>& readings, const Units& units);

/// In words, from its JSON.
[[nodiscard]] std::string improvementText(nlohmann::json figures);

}  // namespace tubeplan::app
