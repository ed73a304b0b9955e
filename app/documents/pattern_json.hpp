// A pattern of the residual as JSON and as a plain sentence.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "calibration/patterns/pattern_search.hpp"

namespace tubeplan::app {

/// What a pattern says, in a plain sentence.
[[nodiscard]] std::string patternSentence(const calibration::PatternTest& test, const Units& units);

/// The figures of a test; of a finding also its course over the variable.
[[nodiscard]] nlohmann::json testJson(const calibration::PatternTest& test, const Units& units);
[[nodiscard]] nlohmann::json findingJson(const calibration::PatternTest& test, const Units& units);

}  // namespace tubeplan::app
