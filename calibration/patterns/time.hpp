// An error that changes with time: a drift, a slip of the base.
//
// Basis: slow waves over the session.
#pragma once

#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration::patterns::time {

inline std::vector<Variable> variables(const ReadingScene& scene) {
  Variable variable{
      "time", VariableUnit::kTime, Eigen::VectorXd(static_cast<Eigen::Index>(scene.readings.size())), {}, {}};
  for (std::size_t k = 0; k < scene.readings.size(); ++k)
    variable.value[static_cast<Eigen::Index>(k)] = scene.readings[k].time;
  if (!varies(variable.value)) return {};
  variable.basis = slowWaves(variable.value);
  return {variable};
}

inline PatternKind kind() { return {.name = "time", .needs = "a column of different times", .variables = variables}; }

}  // namespace tubeplan::calibration::patterns::time
