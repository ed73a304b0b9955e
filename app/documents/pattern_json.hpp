// Pattern found in the residuals, as JSON and as a sentence.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "calibration/patterns/pattern_search.hpp"

namespace tubeplan::app {

/// Returns a sentence on a pattern.
[[nodiscard]] std::string patternSentence(const calibration::PatternTest& test, const Units& units);

/// Returns the results of a pattern test; for a pattern found, also its course over the variable.
[[nodiscard]] nlohmann::json testJson(const calibration::PatternTest& test, const Units& units);
[[nodiscard]] nlohmann::json findingJson(const calibration::PatternTest& test, const Units& units);

}  // namespace tubeplan::app
