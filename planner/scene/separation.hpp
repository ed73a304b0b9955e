// Distance between two convex solids.
#pragma once

#include "planner/scene/shape.hpp"

namespace tubeplan::planner {

/// The nearest points of two segments a0-a1 and b0-b1, degenerate ones included; exact.
struct SegmentPair {
  Eigen::Vector3d on_a, on_b;
};
[[nodiscard]] SegmentPair nearestPoints(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1, const Eigen::Vector3d& b0,
                                        const Eigen::Vector3d& b1);

[[nodiscard]] Capsule transformed(const Eigen::Isometry3d& X_WF, const Capsule& capsule_F);

/// Distance of two capsules, exact: negative where they overlap. The point is on a's surface.
[[nodiscard]] Separation separation(const Capsule& a, const Capsule& b);

/// Distance of a capsule, in b's frame, from b; as the next one.
[[nodiscard]] Separation separation(const Capsule& a, const Solid& b);

/// Distance between solids a and b placed in W. Exact for two capsules (spheres among them). For others nearest points
/// are proposed, in closed form where one of the two is a capsule or a box, and what is returned is the width of the
/// gap between the two supporting planes across them: a lower bound of the distance whatever was proposed. As the
/// points' own distance is an upper bound, a wrong proposal could only cost clearance. The point is a's, in W.
[[nodiscard]] Separation separation(const Eigen::Isometry3d& X_WA, const Solid& a, const Eigen::Isometry3d& X_WB,
                                    const Solid& b);

/// The same with points proposed by the distance library: where two flat-ended cylinders meet, and to compare with.
[[nodiscard]] Separation separationByLibrary(const Eigen::Isometry3d& X_WA, const Solid& a,
                                             const Eigen::Isometry3d& X_WB, const Solid& b);

}  // namespace tubeplan::planner
