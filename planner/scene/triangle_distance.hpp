// Distance of one triangle from a point, a segment and a convex solid.
//
// Each is the greatest width of a gap between two parallel planes, one that supports the triangle and one that supports
// the other thing, over the directions in which the nearest points may lie. Such a width is never more than the
// distance, and in the right direction it is the distance: for triangles that are nearly lines, whose normal is
// not well defined, an error can only cost clearance.
#pragma once

#include "planner/scene/shape.hpp"
#include "planner/scene/triangle_tree.hpp"

namespace tubeplan::planner {

/// Gap [m] below which two bodies cannot be distinguished from touching; it counts as contact and is returned as 0.
inline constexpr double kTriangleContact = 1e-9;

struct TriangleGap {
  double distance;        ///< 0 where they meet [m]
  Eigen::Vector3d point;  ///< nearest point of the segment, or of the solid without its rounding
  /// Unit vector from that point to the triangle; zero where they meet.
  Eigen::Vector3d across = Eigen::Vector3d::Zero();
};

[[nodiscard]] TriangleGap gapTo(const Corners& triangle, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Returns the gap of a triangle given in the solid's frame.
[[nodiscard]] TriangleGap gapTo(const Corners& triangle, const Solid& solid);

/// Returns the distance of a point from a triangle, by its nearest point (Ericson, Real-Time Collision Detection, 2005,
/// section 5.1.5).
[[nodiscard]] double pointGap(const Corners& triangle, const Eigen::Vector3d& p);

/// Returns a lower bound of the distance between a segment and a box with its edges along the axes [m].
[[nodiscard]] double gapToBox(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace tubeplan::planner
