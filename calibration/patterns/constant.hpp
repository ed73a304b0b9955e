// Error that is the same at every measurement: in the world frame, in radial axes around the vertical through the base,
// or in the tool frame.
//
// Basis: the constant 1.
#pragma once

#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration::patterns::constant {

inline std::vector<Variable> variables(const MeasurementScene& scene) {
  const auto n = static_cast<Eigen::Index>(scene.measurements.size());
  return {{"constant", {}, Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Ones(n, 1), {}}};
}

inline PatternKind kind() { return {.name = "constant", .needs = "readings", .variables = variables}; }

}  // namespace tubeplan::calibration::patterns::constant
