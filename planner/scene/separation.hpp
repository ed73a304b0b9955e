// Distance between two convex solids.
#pragma once

#include "planner/scene/shape.hpp"

namespace tubeplan::planner {

/// Nearest points of two segments a0-a1 and b0-b1, degenerate ones included; exact.
struct SegmentPair {
  Eigen::Vector3d on_a, on_b;
};
[[nodiscard]] SegmentPair nearestPoints(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1, const Eigen::Vector3d& b0,
                                        const Eigen::Vector3d& b1);

[[nodiscard]] Capsule transformed(const Eigen::Isometry3d& X_WF, const Capsule& capsule_F);

/// Returns the distance of two capsules, exact: negative if they overlap. The point is on a's surface.
[[nodiscard]] Separation separation(const Capsule& a, const Capsule& b);

/// Returns the distance of a capsule, in b's frame, from b, by the method for two solids.
[[nodiscard]] Separation separation(const Capsule& a, const Solid& b);

/// Returns the distance between solids a and b placed in W, exact for two capsules (spheres among them). For others
/// nearest points are proposed, in closed form if one of the two is a capsule or a box. The result is the gap between
/// the two supporting planes across them: a lower bound of the distance for any proposal. The points' own distance is
/// an upper bound, so that a wrong proposal could only cost clearance. The point is a's, in W.
[[nodiscard]] Separation separation(const Eigen::Isometry3d& X_WA, const Solid& a, const Eigen::Isometry3d& X_WB,
                                    const Solid& b);

/// Returns the same distance with points proposed by the distance library: for two flat-ended cylinders, and for
/// comparison.
[[nodiscard]] Separation separationByLibrary(const Eigen::Isometry3d& X_WA, const Solid& a,
                                             const Eigen::Isometry3d& X_WB, const Solid& b);

}  // namespace tubeplan::planner
