// Pattern of the residual as JSON and as a plain sentence.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "calibration/patterns/pattern_search.hpp"

namespace tubeplan::app {

/// Returns a pattern in a plain sentence.
[[nodiscard]] std::string patternSentence(const calibration::PatternTest& test, const Units& units);

/// Returns the figures of a test; for a finding also its course over the variable.
[[nodiscard]] nlohmann::json testJson(const calibration::PatternTest& test, const Units& units);
[[nodiscard]] nlohmann::json findingJson(const calibration::PatternTest& test, const Units& units);

}  // namespace tubeplan::app
