// Stepwise improvement of a model, as JSON and in words.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/studies/model/improvement.hpp"

namespace tubeplan::app {

/// Returns "adequate", "nothing-sure", ...
[[nodiscard]] const char* nameOf(ImprovementEnd end);

/// Returns the reason for adding a cause, or for ending the loop.
[[nodiscard]] std::string reasonText(const ImprovementStep& step, const Units& units);

/// Returns the document that `tubeplan improve --json` writes.
[[nodiscard]] nlohmann::json improvementJson(const Improvement& result,
                                             const std::vector<calibration::Measurement>& readings, const Units& units);

/// Returns the improvement in words, from its JSON.
[[nodiscard]] std::string improvementText(nlohmann::json figures);

}  // namespace tubeplan::app
