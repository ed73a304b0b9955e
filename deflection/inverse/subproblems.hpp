// Paden-Kahan subproblems: rotations about known axes, from which closed-form solutions are composed (Paden 1985).
// Internal to the inverse kinematics.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace tubeplan::deflection {

/// Returns the solutions x [rad] of a cos x + b sin x = c: two, one if they coincide, or none if |c| exceeds the
/// amplitude by more than the fraction `slack`.
inline std::vector<double> solveCosineSine(double a, double b, double c, double slack = 1e-12) {
  const double r = std::hypot(a, b);
  if (r == 0 || std::abs(c) > r * (1 + slack)) return {};
  const double middle = std::atan2(b, a), half = std::acos(std::clamp(c / r, -1., 1.));
  if (half < 1e-9) return {middle};
  return {middle + half, middle - half};
}

/// Returns the rotations [rad] about a unit axis through the origin that give a point p the component `offset` along
/// the fixed direction h.
inline std::vector<double> solveOffset(const Eigen::Vector3d& axis, const Eigen::Vector3d& h, const Eigen::Vector3d& p,
                                       double offset) {
  const Eigen::Vector3d along = axis * axis.dot(h), across = h - along;
  return solveCosineSine(across.dot(p), axis.cross(across).dot(p), offset - along.dot(p));
}

/// Returns the rotation about a unit axis that takes a to b as seen along the axis [rad]; zero if a or b lies on the
/// axis.
inline double turnBetween(const Eigen::Vector3d& axis, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(axis.dot(a.cross(b)), a.dot(b) - axis.dot(a) * axis.dot(b));
}

/// A plane perpendicular to parallel axes, with 2-D coordinates.
struct Plane {
  Eigen::Vector3d origin, u, v;
  Eigen::Vector2d operator()(const Eigen::Vector3d& p) const { return {u.dot(p - origin), v.dot(p - origin)}; }
  Eigen::Vector2d direction(const Eigen::Vector3d& d) const { return {u.dot(d), v.dot(d)}; }
};

inline double angleOf(const Eigen::Vector2d& d) { return std::atan2(d.y(), d.x()); }
inline Eigen::Vector2d turned(const Eigen::Vector2d& d, double angle) { return Eigen::Rotation2Dd(angle) * d; }

/// Largest |cosine| of the elbow angle that a goal may require. Values slightly above 1 are allowed, because deflection
/// extends the reach.
inline constexpr double kLargestElbowCosine = 1.1;

/// Returns the shoulder and elbow angles [rad] that bring the wrist to `w`. The shoulder is at the plane's origin;
/// `elbow` and `wrist` are positions at zero readings.
inline std::vector<Eigen::Vector2d> solveTwoLinks(const Eigen::Vector2d& elbow, const Eigen::Vector2d& wrist,
                                                  const Eigen::Vector2d& w) {
  const Eigen::Vector2d upper = elbow, fore = wrist - elbow;
  const double l1 = upper.norm(), l2 = fore.norm();
  const double c = (w.squaredNorm() - l1 * l1 - l2 * l2) / (2 * l1 * l2);
  if (!(std::abs(c) <= kLargestElbowCosine)) return {};
  // A deflected arm may reach slightly further than a rigid one. For a goal just out of rigid reach, start from a
  // slightly bent elbow.
  const double at_zero = angleOf(fore) - angleOf(upper),
               bend = std::acos(std::abs(c) <= 1 ? c : std::copysign(0.98, c));
  std::vector<Eigen::Vector2d> solutions;
  for (double sign : {1., -1.}) {
    const double elbow_angle = sign * bend - at_zero;
    const Eigen::Vector2d reach = upper + turned(fore, elbow_angle);
    solutions.push_back({angleOf(w) - angleOf(reach), elbow_angle});
    if (bend < 1e-9) break;
  }
  return solutions;
}

}  // namespace tubeplan::deflection
