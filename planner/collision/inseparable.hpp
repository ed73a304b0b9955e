// Pairs of bodies of the nominal arm that are too close to each other in every posture, such as a wrist flange inside
// the end of the forearm.
#pragma once

#include <utility>
#include <vector>

#include "deflection/arm.hpp"
#include "planner/scene/scene.hpp"

namespace tubeplan::planner {

/// Returns the pairs for which areJudged() is true and that are closer than the scene's clearance in each of 1,000
/// postures spread over the joint limits, computed with rigid kinematics. No plan could keep such bodies apart, so
/// Scene::inseparable lists them instead. A pair holds two indices of bodies, the smaller first.
[[nodiscard]] std::vector<std::pair<int, int>> inseparableBodies(const deflection::Arm& arm, const Scene& scene);

}  // namespace tubeplan::planner
