// Separate error of each set-up.
//
// Basis: one parameter per set-up.
#pragma once

#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration::patterns::setup {

inline std::vector<Variable> variables(const MeasurementScene& scene) {
  std::vector<std::string> names;
  for (const auto& measurement : scene.measurements) names.push_back(measurement.setup);
  const Variable variable = groupVariable("set-up", names);
  if (variable.groups.size() < 2) return {};
  return {variable};
}

inline PatternKind kind() { return {.name = "set-up", .needs = "two set-ups", .variables = variables}; }

}  // namespace tubeplan::calibration::patterns::setup
