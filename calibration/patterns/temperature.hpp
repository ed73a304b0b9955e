// An error that goes with the temperature.
//
// Basis: the temperature.
#pragma once

#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration::patterns::temperature {

inline std::vector<Variable> variables(const ReadingScene& scene) {
  Variable variable{"temperature",
                    VariableUnit::kTemperature,
                    Eigen::VectorXd(static_cast<Eigen::Index>(scene.readings.size())),
                    {},
                    {}};
  for (std::size_t k = 0; k < scene.readings.size(); ++k)
    variable.value[static_cast<Eigen::Index>(k)] = scene.readings[k].temperature;
  if (!varies(variable.value)) return {};
  variable.basis = centred(variable.value, [](double t) { return t; });
  return {variable};
}

inline PatternKind kind() {
  return {.name = "temperature", .needs = "a column of different temperatures", .variables = variables};
}

}  // namespace tubeplan::calibration::patterns::temperature
