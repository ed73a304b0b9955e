// What a pattern follows, as a sentence says it.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::calibration {

/// "the direction of approach of theta4" of the variable "sense of theta4"; others are said as they are named.
[[nodiscard]] inline std::string variableWords(const std::string& variable) {
  constexpr std::string_view kSense = "sense of ";
  return variable.starts_with(kSense) ? "the direction of approach of " + variable.substr(kSense.size()) : variable;
}

}  // namespace tubeplan::calibration
