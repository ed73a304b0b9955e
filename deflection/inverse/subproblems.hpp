// Small problems of rotations about known axes, from which closed forms are built (Paden 1985, Kahan). Internal to the
// inverse.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace tubeplan::deflection {

/// Returns both solutions of a cos x + b sin x = c; none if |c| exceeds the amplitude by more than the share `slack`.
inline std::vector<double> solveCosineSine(double a, double b, double c, double slack = 1e-12) {
  const double r = std::hypot(a, b);
  if (r == 0 || std::abs(c) > r * (1 + slack)) return {};
  const double middle = std::atan2(b, a), half = std::acos(std::clamp(c / r, -1., 1.));
  if (half < 1e-9) return {middle};
  return {middle + half, middle - half};
}

/// Returns the rotations about a unit axis through the origin that move a point p to a component of `offset` along the
/// fixed direction h.
inline std::vector<double> solveOffset(const Eigen::Vector3d& axis, const Eigen::Vector3d& h, const Eigen::Vector3d& p,
                                       double offset) {
  const Eigen::Vector3d along = axis * axis.dot(h), across = h - along;
  return solveCosineSine(across.dot(p), axis.cross(across).dot(p), offset - along.dot(p));
}

/// Returns the rotation about a unit axis that takes a to b as seen along it [rad]; zero if either lies on it.
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

/// Largest |cosine| of an elbow: goals beyond it are out of reach with any deflection.
inline constexpr double kMostBeyond = 1.1;

/// Returns the shoulder and elbow angles that bring the wrist to `w`, with the shoulder at the plane's origin, `elbow`
/// and `wrist` at zero readings.
inline std::vector<Eigen::Vector2d> solveTwoLinks(const Eigen::Vector2d& elbow, const Eigen::Vector2d& wrist,
                                                  const Eigen::Vector2d& w) {
  const Eigen::Vector2d upper = elbow, fore = wrist - elbow;
  const double l1 = upper.norm(), l2 = fore.norm();
  const double c = (w.squaredNorm() - l1 * l1 - l2 * l2) / (2 * l1 * l2);
  if (!(std::abs(c) <= kMostBeyond)) return {};
  // A bent arm may reach a little further than a rigid one: the elbow is started slightly bent there.
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
