// Error that depends on the moment about an axis of a row, as compliance or clearance would cause.
//
// Basis: the moment; also its sign if both signs are frequent. Moments that are multiples of one another are tested
// once.
#pragma once

#include <algorithm>
#include <cmath>

#include "calibration/patterns/pattern.hpp"

namespace tubeplan::calibration::patterns::moment {

// Two moments are treated as proportional if 1 - |correlation| is at most this.
inline constexpr double kSameCourse = 1e-6;
// A moment is tested only if it varies by more than this fraction of the arm's largest moment.
inline constexpr double kLeastShare = 1e-3;
// The sign of a moment is tested only if each sign occurs in at least this fraction of the measurements.
inline constexpr double kFewestOfSign = 0.05;

inline Eigen::VectorXd momentsAbout(const MeasurementScene& scene, Eigen::Index row, int axis) {
  Eigen::VectorXd moments(static_cast<Eigen::Index>(scene.measurements.size()));
  for (std::size_t k = 0; k < scene.measurements.size(); ++k)
    moments[static_cast<Eigen::Index>(k)] = scene.moments_L[k](axis, row);
  return moments;
}

inline bool isAlreadyListed(const std::vector<Variable>& list, const Eigen::VectorXd& course) {
  return std::any_of(list.begin(), list.end(), [&](const Variable& other) {
    return std::abs(other.basis.col(0).normalized().dot(course.normalized())) > 1 - kSameCourse;
  });
}

inline std::vector<Variable> variables(const MeasurementScene& scene) {
  double largest = 0;
  for (const auto& moments : scene.moments_L) largest = std::max(largest, moments.cwiseAbs().maxCoeff());
  std::vector<Variable> list;
  for (std::size_t row = 0; row < scene.placed.arm.rows.size(); ++row)
    for (int axis = 0; axis < 3; ++axis) {
      Variable variable{"moment " + scene.placed.arm.rows[row].name + "." + "xyz" [axis],
                        { deflection::Quantity::kTorque },
                        momentsAbout(scene, static_cast<Eigen::Index>(row), axis),
                        {},
                        {}};
      const Eigen::VectorXd course = centred(variable.value, [](double m) { return m; });
      if (course.cwiseAbs().maxCoeff() <= kLeastShare * largest || isAlreadyListed(list, course)) continue;
      const double positive = (variable.value.array() > 0).cast<double>().mean();
      const bool has_both = std::min(positive, 1 - positive) >= kFewestOfSign;
      variable.basis.resize(course.size(), has_both ? 2 : 1);
      variable.basis.col(0) = course;
      if (has_both) variable.basis.col(1) = centred(variable.value, [](double m) { return m > 0 ? 1. : -1.; });
      list.push_back(std::move(variable));
    }
  return list;
}

inline PatternKind kind() { return {.name = "moment", .needs = "weights or loads", .variables = variables}; }

}  // namespace tubeplan::calibration::patterns::moment
