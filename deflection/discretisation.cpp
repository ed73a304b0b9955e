#include "deflection/discretisation.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace tubeplan::deflection {

namespace {

constexpr int kMostTimes = 32;

Arm withTimesSegments(Arm arm, int times) {
  for (auto& row : arm.rows)
    if (row.beam) row.beam->segments *= times;
  return arm;
}

std::optional<Eigen::Vector3d> tipOf(const Arm& arm, const Posture& posture) {
  const auto shape = solveFlexibleKinematics(arm, posture);
  if (shape.status != KinematicsStatus::kConverged) return std::nullopt;
  return shape.X_BD.p;
}

}  // namespace

int mostSegments(const Arm& arm) {
  int most = 0;
  for (const auto& row : arm.rows)
    if (row.beam) most = std::max(most, row.beam->segments);
  return most;
}

Discretisation discretisationOf(const Arm& arm, const Posture& posture, double allowed) {
  Discretisation found;
  if (mostSegments(arm) == 0) return found;
  found.factor = 0;
  auto coarse = tipOf(arm, posture);
  for (int times = 1; times <= kMostTimes && found.factor == 0; times *= 2) {
    const auto fine = tipOf(withTimesSegments(arm, 2 * times), posture);
    const double error =
        coarse && fine ? 4.0 / 3.0 * (*fine - *coarse).norm() : std::numeric_limits<double>::quiet_NaN();
    if (times == 1) found.tip_error = error;
    if (error <= allowed) found.factor = times;
    coarse = fine;
  }
  return found;
}

}  // namespace tubeplan::deflection
