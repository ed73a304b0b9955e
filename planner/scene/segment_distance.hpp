// Nearest points of a line segment and a box or a cylinder.
//
// Along a segment the squared distance from a convex solid is convex, so its slope increases, and the nearest point is
// where the slope is zero. It is found by Newton steps kept within a bracket that shrinks at each step.
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
