// Error that depends on the direction of a joint's last motion.
//
// Basis: the sign of the joint's last motion, -1 or +1; 0 if unknown.
#pragma once

#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration::patterns::joint_sense {

inline std::vector<Variable> variables(const MeasurementScene& scene) {
  std::vector<Variable> list;
  for (Eigen::Index j = 0; j < scene.placed.arm.jointCount(); ++j) {
    Variable variable{"sense of " + scene.placed.arm.joint(j).name, {}, {}, {}, {}};
    variable.value.resize(static_cast<Eigen::Index>(scene.measurements.size()));
    for (std::size_t k = 0; k < scene.measurements.size(); ++k) {
      const auto& approach_directions = scene.measurements[k].approach_directions;
      variable.value[static_cast<Eigen::Index>(k)] = approach_directions.empty() ? 0 : approach_directions[j];
    }
    if (!varies(variable.value)) continue;
    variable.basis = centred(variable.value, [](double s) { return s; });
    list.push_back(std::move(variable));
  }
  return list;
}

inline PatternKind kind() {
  return {.name = "sense", .needs = "a column <joint>_dir with both senses", .variables = variables};
}

}  // namespace tubeplan::calibration::patterns::joint_sense
