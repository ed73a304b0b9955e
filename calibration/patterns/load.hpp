// Error that depends on the load hung from the tip.
//
// Basis: the load; also its square if there are three or more different loads.
#pragma once

#include <set>

#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration::patterns::load {

inline std::vector<Variable> variables(const MeasurementScene& scene) {
  Variable variable{"load",
                    {deflection::Quantity::kForce},
                    Eigen::VectorXd(static_cast<Eigen::Index>(scene.measurements.size())),
                    {},
                    {}};
  std::set<double> loads;
  for (std::size_t k = 0; k < scene.measurements.size(); ++k) {
    variable.value[static_cast<Eigen::Index>(k)] = scene.measurements[k].load;
    loads.insert(scene.measurements[k].load);
  }
  if (!varies(variable.value)) return {};
  variable.basis.resize(variable.value.size(), loads.size() > 2 ? 2 : 1);
  variable.basis.col(0) = centred(variable.value, [](double f) { return f; });
  if (loads.size() > 2) variable.basis.col(1) = centred(variable.value, [](double f) { return f * f; });
  return {variable};
}

inline PatternKind kind() { return {.name = "load", .needs = "two loads", .variables = variables}; }

}  // namespace tubeplan::calibration::patterns::load
