// Results of pattern tests on the residuals, as JSON and as sentences.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "calibration/patterns/pattern_search.hpp"

namespace tubeplan::app {

/// Returns a sentence on how the error depends on the tested variable; empty if the test names no component of the
/// error.
[[nodiscard]] std::string patternSentence(const calibration::PatternTest& test, const Units& units);

/// Returns the results of a pattern test; findingJson() adds the trend over the variable and the stronger finding, if
/// any, that also explains the pattern.
[[nodiscard]] nlohmann::json testJson(const calibration::PatternTest& test, const Units& units);
[[nodiscard]] nlohmann::json findingJson(const calibration::PatternTest& test, const Units& units);

}  // namespace tubeplan::app
