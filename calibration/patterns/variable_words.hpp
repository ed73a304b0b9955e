// Words for the variable of a pattern, for sentences.
#pragma once

#include <string>
#include <string_view>

#include "deflection/conditions.hpp"

namespace tubeplan::calibration {

/// Returns "the direction of approach of theta4" for the variable "sense of theta4", "the load" for "load"; joints and
/// moments keep their names.
[[nodiscard]] inline std::string variableWords(const std::string& variable) {
  constexpr std::string_view kSense = "sense of ";
  if (variable.starts_with(kSense)) return "the direction of approach of " + variable.substr(kSense.size());
  for (const auto* plain : {"point", "set-up", "load"})
    if (variable == plain) return "the " + variable;
  for (const auto& condition : deflection::kConditionKinds)
    if (variable == condition.name) return condition.words;
  return variable == "order" ? "the order of the readings" : variable;
}

}  // namespace tubeplan::calibration
