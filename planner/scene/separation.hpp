// Distance between two convex solids.
#pragma once

#include "planner/scene/shape.hpp"

namespace tubeplan::planner {

/// Nearest points of two segments a0-a1 and b0-b1, computed exactly; a segment may be a single point.
struct SegmentPair {
  Eigen::Vector3d on_a, on_b;
};
[[nodiscard]] SegmentPair nearestPoints(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1, const Eigen::Vector3d& b0,
                                        const Eigen::Vector3d& b1);

[[nodiscard]] Capsule transformed(const Eigen::Isometry3d& X_WF, const Capsule& capsule_F);

/// Returns the exact distance between two capsules, negative if they overlap. The returned point is on the surface of
/// a.
[[nodiscard]] Separation separation(const Capsule& a, const Capsule& b);

/// Returns the distance between solid b and capsule a, which is given in b's frame, by the same method as for two
/// solids.
[[nodiscard]] Separation separation(const Capsule& a, const Solid& b);

/// Returns the distance between solids a and b placed in W, exact for two capsules (including spheres). For other
/// solids, the nearest points are estimated, in closed form if a or b is a capsule or a box. The result is the gap
/// between two planes perpendicular to the line through these points, one supporting a and one supporting b. It never
/// exceeds the true distance, so inaccurate points give a conservative result. The returned point is on a, in W.
[[nodiscard]] Separation separation(const Eigen::Isometry3d& X_WA, const Solid& a, const Eigen::Isometry3d& X_WB,
                                    const Solid& b);

/// Returns the same distance, but with nearest points found by the distance library (FCL). Used for two flat-ended
/// cylinders, and for comparison with separation().
[[nodiscard]] Separation separationByLibrary(const Eigen::Isometry3d& X_WA, const Solid& a,
                                             const Eigen::Isometry3d& X_WB, const Solid& b);

}  // namespace tubeplan::planner
