// Nearest points of a segment and a box or a cylinder.
//
// Along a segment the squared distance from a convex solid is convex, so its slope rises, and the nearest place is
// where the slope is zero: found by Newton steps kept within a bracket that shrinks at each.
#pragma once

#include <Eigen/Core>

namespace tubeplan::planner {

/// Two points, one of a segment and one of a solid; the same point where they meet.
struct SegmentNearest {
  Eigen::Vector3d on_segment, on_solid;
};

/// Returns the nearest points of a segment and the box |x| <= half.x, |y| <= half.y, |z| <= half.z.
[[nodiscard]] SegmentNearest nearestToBox(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                          const Eigen::Vector3d& half);

/// Returns the nearest points of a segment and the cylinder about z with flat ends at z = -half_length and z =
/// half_length.
[[nodiscard]] SegmentNearest nearestToCylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                                               double half_length);

}  // namespace tubeplan::planner
