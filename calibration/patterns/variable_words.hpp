// Noun phrases for the variables of patterns, for use in sentences.
#pragma once

#include <string>
#include <string_view>

#include "deflection/conditions.hpp"

namespace tubeplan::calibration {

/// Returns a noun phrase for a variable, such as "the direction of approach of theta4" for "sense of theta4" or "the
/// load" for "load". Joints and moments keep their names.
[[nodiscard]] inline std::string variableWords(const std::string& variable) {
  constexpr std::string_view kSense = "sense of ";
  if (variable.starts_with(kSense)) return "the direction of approach of " + variable.substr(kSense.size());
  for (const auto* plain : {"point", "set-up", "load", "order of the readings"})
    if (variable == plain) return "the " + variable;
  for (const auto& condition : deflection::kConditionKinds)
    if (variable == condition.name) return condition.words;
  return variable;
}

}  // namespace tubeplan::calibration
