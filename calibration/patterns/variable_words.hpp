// What a pattern follows, as a sentence says it.
#pragma once

#include <string>
#include <string_view>

#include "deflection/conditions.hpp"

namespace tubeplan::calibration {

/// "the direction of approach of theta4" of the variable "sense of theta4", "the load" of "load"; joints and moments
/// are said as they are named.
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
