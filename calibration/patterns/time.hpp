// An error that changes with time: a drift, a slip of the base.
//
// Basis: slow waves over the session; apart from them, where there are readings enough, up to twelve cycles.
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
  Variable cycles = variable;
  cycles.name = cyclesOf(variable.name);
  cycles.basis = fasterWaves(variable.value);
  return cycles.basis.cols() > 0 ? std::vector<Variable>{variable, cycles} : std::vector<Variable>{variable};
}

inline PatternKind kind() { return {.name = "time", .needs = "a column of different times", .variables = variables}; }

}  // namespace tubeplan::calibration::patterns::time
