// Distance of one triangle from a point, a segment and a convex solid.
//
// Each is the greatest width of a gap between two parallel planes, one that supports the triangle and one that supports
// the other thing, over the directions in which the nearest points may lie. Such a width is never more than the
// distance, and in the right direction it is the distance: triangles that are all but lines, whose face has no telling
// direction, can only cost clearance.
#pragma once

#include "planner/scene/shape.hpp"
#include "planner/scene/triangle_tree.hpp"

namespace tubeplan::planner {

/// Below this [m] a gap cannot be told from contact; it counts as contact and is given as 0.
inline constexpr double kTriangleContact = 1e-9;

struct TriangleGap {
  double distance;                                   ///< m; 0 where they meet
  Eigen::Vector3d point;                             ///< of the segment, or of the solid without its rounding
  Eigen::Vector3d across = Eigen::Vector3d::Zero();  ///< of length 1, from there to the triangle; zero where they meet
};

[[nodiscard]] TriangleGap gapTo(const Corners& triangle, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// The triangle stands in the solid's frame.
[[nodiscard]] TriangleGap gapTo(const Corners& triangle, const Solid& solid);

/// By the nearest point of the triangle alone (Ericson, Real-Time Collision Detection, 2005, section 5.1.5).
[[nodiscard]] double pointGap(const Corners& triangle, const Eigen::Vector3d& p);

/// A lower bound of the distance between a segment and a box with its edges along the axes [m].
[[nodiscard]] double gapToBox(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace tubeplan::planner
