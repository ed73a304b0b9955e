// Where the bodies of bent members are taken to be: along their chords, with the bow taken off the clearance.
#pragma once

#include <vector>

#include "deflection/flexible_kinematics.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::planner {

/// A row's member without deflection, in its axes [m].
[[nodiscard]] Eigen::Vector3d memberOf(const deflection::Arm& arm, int row);

/// Each row's frame in the world, turned so that its member lies along the bent member's chord. `bow` gets the greatest
/// distance of a bent member from its chord [m]; it may be null.
[[nodiscard]] std::vector<Eigen::Isometry3d> framesAlongChords(const Workcell& cell,
                                                               const deflection::FlexibleKinematics& shape,
                                                               double* bow);

}  // namespace tubeplan::planner
