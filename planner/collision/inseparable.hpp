// Pairs of bodies of the nominal arm that are too close to each other in every posture, such as a wrist flange inside
// the end of the forearm.
#pragma once

#include <utility>
#include <vector>

#include "deflection/arm.hpp"
#include "planner/scene/scene.hpp"

namespace tubeplan::planner {

/// Returns the pairs, among those with areJudged(), that are closer than the scene's clearance in each of 1,000
/// postures. The postures are spread over the joint limits and computed with rigid kinematics. No plan could keep such
/// bodies apart, so they are listed in Scene::inseparable and not checked. A pair holds two indices of bodies, the
/// smaller first.
[[nodiscard]] std::vector<std::pair<int, int>> inseparableBodies(const deflection::Arm& arm, const Scene& scene);

}  // namespace tubeplan::planner
