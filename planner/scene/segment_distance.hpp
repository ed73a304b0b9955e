// Nearest points of a line segment and a box or a cylinder.
//
// The squared distance from a convex solid is a convex function of the position along the segment, so that its slope
// never decreases. The nearest point is where the slope is zero, or else at an end. Newton steps find it, kept within a
// bracket that shrinks at each step.
#pragma once

#include <Eigen/Core>

namespace tubeplan::planner {

/// Nearest points of a segment and a solid; identical where the two meet.
struct SegmentNearest {
  Eigen::Vector3d on_segment, on_solid;
};

/// Returns the nearest points of a segment and the box |x| <= half.x, |y| <= half.y, |z| <= half.z.
[[nodiscard]] SegmentNearest nearestToBox(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                          const Eigen::Vector3d& half);

/// Returns the nearest points of a segment and the cylinder along z with flat ends at z = -half_length and z =
/// half_length.
[[nodiscard]] SegmentNearest nearestToCylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                                               double half_length);

}  // namespace tubeplan::planner
