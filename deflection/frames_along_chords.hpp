// Frames of bodies on bent members, aligned with the members' chords; the bow is subtracted from clearances.
#pragma once

#include <vector>

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

/// Returns each row's frame in the world, turned so that its member lies along the bent member's chord. `bow` receives
/// the greatest distance of a bent member from its chord [m]; it may be null.
[[nodiscard]] std::vector<Eigen::Isometry3d> framesAlongChords(const Arm& arm, const Eigen::Isometry3d& X_WB,
                                                               const FlexibleKinematics& shape, double* bow);

}  // namespace tubeplan::deflection
