// Error that depends on a condition stated by the measurements: one pattern for each row of deflection/conditions.hpp.
//
// Basis: the condition itself or, for conditions with slow effects (a drift, a slip of the base), slow waves over the
// range of the condition. If there are enough measurements, faster waves of up to twelve cycles form a second variable.
#pragma once

#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration::patterns::condition {

inline std::vector<Variable> variables(const MeasurementScene& scene, const deflection::ConditionKind& kind) {
  Variable variable{
      kind.name, kind.unit, Eigen::VectorXd(static_cast<Eigen::Index>(scene.measurements.size())), {}, {}};
  for (std::size_t k = 0; k < scene.measurements.size(); ++k)
    variable.value[static_cast<Eigen::Index>(k)] = scene.measurements[k].conditions[kind.condition];
  if (!varies(variable.value)) return {};
  if (kind.course == deflection::Course::kProportional) {
    variable.basis = centred(variable.value, [](double value) { return value; });
    return {variable};
  }
  variable.basis = slowWaves(variable.value);
  Variable cycles = variable;
  cycles.name = cyclesOf(variable.name);
  cycles.basis = fasterWaves(variable.value);
  return cycles.basis.cols() > 0 ? std::vector<Variable>{variable, cycles} : std::vector<Variable>{variable};
}

inline PatternKind kind(const deflection::ConditionKind& of) {
  return {.name = of.name,
          .needs = std::string("a column of different values of ") + of.words,
          .variables = [&of](const MeasurementScene& scene) { return variables(scene, of); }};
}

}  // namespace tubeplan::calibration::patterns::condition
