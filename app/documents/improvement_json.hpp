// How a model was improved step by step, as JSON and in words.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/files/units.hpp"
#include "app/studies/model/improvement.hpp"

namespace tubeplan::app {

/// "adequate", "nothing-sure", ...
[[nodiscard]] const char* nameOf(ImprovementEnd end);

/// The sentence of a step's diagnosis.
[[nodiscard]] std::string sentenceOf(const ImprovementStep& step, const Units& units);

/// Why a cause was added, or why the loop ends there.
[[nodiscard]] std::string reasonText(const ImprovementStep& step, const Units& units);

/// The ids of the readings that no model was fitted to, as the last diagnosis took them for outliers.
[[nodiscard]] std::vector<std::string> idsSetAside(const Improvement& result,
                                                   const std::vector<calibration::Measurement>& readings);

/// What was added, what became of the held-out error, and what is left, in one sentence.
[[nodiscard]] std::string improvementSentence(const Improvement& result, const Units& units);

/// As `tubeplan improve --json` writes it.
[[nodiscard]] nlohmann::json improvementJson(const Improvement& result,
                                             const std::vector<calibration::Measurement>& readings, const Units& units);

}  // namespace tubeplan::app
