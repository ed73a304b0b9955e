// Distance of a triangle from a point, a segment and a convex solid.
//
// Each distance is computed as the width of a gap between two parallel planes, one supporting the triangle and the
// other the point, segment or solid. The widest gap is taken over the directions in which the nearest points may lie.
// No such gap is wider than the distance, and the gap along the line of the nearest points is just as wide. Errors in
// the normal of a nearly degenerate triangle therefore give a conservative result.
#pragma once

#include "planner/scene/shape.hpp"
#include "planner/scene/triangle_tree.hpp"

namespace tubeplan::planner {

/// Gap [m] below which a body and a triangle cannot be distinguished from touching; it is treated as contact, and
/// returned as 0.
inline constexpr double kTriangleContact = 1e-9;

struct TriangleGap {
  double distance;        ///< gap; 0 where triangle and body meet [m]
  Eigen::Vector3d point;  ///< nearest point of the segment, or of the solid without its rounding
  /// Unit vector from `point` to the triangle; zero where triangle and body meet.
  Eigen::Vector3d across = Eigen::Vector3d::Zero();
};

[[nodiscard]] TriangleGap gapTo(const Corners& triangle, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Returns the gap between a solid without its rounding and a triangle given in the solid's frame.
[[nodiscard]] TriangleGap gapTo(const Corners& triangle, const Solid& solid);

/// Returns the distance of a point from a triangle, computed from the triangle's nearest point (Ericson, Real-Time
/// Collision Detection, 2005, section 5.1.5) [m].
[[nodiscard]] double pointGap(const Corners& triangle, const Eigen::Vector3d& p);

/// Returns a lower bound of the distance [m] between a segment and a box whose edges are parallel to the axes.
[[nodiscard]] double gapToBox(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace tubeplan::planner
