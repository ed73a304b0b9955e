// Error that depends on the tip's position in the world frame.
//
// Basis: a coordinate and its square, relative to the mean of the measurements. For a touch of a known point, the
// position is that of the point, because the predicted tip position contains the error. A coordinate that hardly varies
// is not tested, because it would show only noise.
#pragma once

#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration::patterns::place {

// A coordinate is tested only if it ranges over at least this fraction of the arm's reach.
inline constexpr double kLeastShare = 0.002;

inline Eigen::Matrix3Xd places(const MeasurementScene& scene) {
  Eigen::Matrix3Xd places = scene.tips;
  for (std::size_t k = 0; k < scene.measurements.size(); ++k)
    if (touchesKnownPoint(scene.measurements[k])) places.col(static_cast<Eigen::Index>(k)) = *scene.measurements[k].p_W;
  return places;
}

inline std::vector<Variable> variables(const MeasurementScene& scene) {
  const Eigen::Matrix3Xd at = places(scene);
  const double least = kLeastShare * deflection::reachOf(scene.placed.arm);
  std::vector<Variable> list;
  for (int axis = 0; axis < 3; ++axis) {
    Variable variable{std::string("position ") + "xyz" [axis], { deflection::Quantity::kLength }, at.row(axis), {}, {}};
    if (variable.value.maxCoeff() - variable.value.minCoeff() < least) continue;
    variable.basis.resize(variable.value.size(), 2);
    variable.basis.col(0) = centred(variable.value, [](double p) { return p; });
    variable.basis.col(1) = centred(variable.basis.col(0), [](double p) { return p * p; });
    list.push_back(std::move(variable));
  }
  return list;
}

inline PatternKind kind() { return {.name = "position", .needs = "different positions", .variables = variables}; }

}  // namespace tubeplan::calibration::patterns::place
