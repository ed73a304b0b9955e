// Row frames aligned with the chords of bent members. Collision checks fix bodies to these frames, and subtract the
// distance between member and chord from clearances.
#pragma once

#include <vector>

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

/// Returns each row's frame in the world, rotated so that its undeflected member lies along the bent member's chord.
/// `bow`, if not null, receives the largest distance of a bent member from its chord [m].
[[nodiscard]] std::vector<Eigen::Isometry3d> framesAlongChords(const Arm& arm, const Eigen::Isometry3d& X_WB,
                                                               const FlexibleKinematics& shape, double* bow);

}  // namespace tubeplan::deflection
