// Stepwise improvement of a model, as JSON and as text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "app/studies/model/improvement.hpp"

namespace tubeplan::app {

/// Returns the name, in documents, of the reason for ending the loop: "adequate", "nothing-sure", ...
[[nodiscard]] const char* nameOf(ImprovementEnd end);

/// Returns, as a clause, the reason why a step added a cause or ended the loop.
[[nodiscard]] std::string reasonText(const ImprovementStep& step, const Units& units);

/// Returns the JSON that `tubeplan improve --json` writes.
[[nodiscard]] nlohmann::json improvementJson(const Improvement& result,
                                             const std::vector<calibration::Measurement>& measurements,
                                             const Units& units);

/// Returns the text of an improvement, generated from the JSON of improvementJson().
[[nodiscard]] std::string improvementText(nlohmann::json figures);

}  // namespace tubeplan::app
