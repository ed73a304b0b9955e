// Error that neighbouring measurements in the file share.
//
// Basis: slow waves over the order of the measurements.
#pragma once

#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration::patterns::order {

inline std::vector<Variable> variables(const MeasurementScene& scene) {
  const auto n = static_cast<Eigen::Index>(scene.measurements.size());
  if (n < 4) return {};
  Variable variable{"order of the readings", {}, Eigen::VectorXd::LinSpaced(n, 1, static_cast<double>(n)), {}, {}};
  variable.basis = slowWaves(variable.value);
  return {variable};
}

inline PatternKind kind() { return {.name = "order", .needs = "four readings", .variables = variables}; }

}  // namespace tubeplan::calibration::patterns::order
