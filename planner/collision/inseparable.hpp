// Bodies of the nominal arm that are too near each other in every posture, such as a wrist's flange in the forearm's
// end.
#pragma once

#include <utility>
#include <vector>

#include "deflection/arm.hpp"
#include "planner/scene/scene.hpp"

namespace tubeplan::planner {

/// Returns the pairs to be judged (areJudged()) that are nearer than the scene's clearance at each of 1,000 postures
/// all over the joints' limits, by rigid kinematics. No plan could keep them apart, so that Scene::inseparable lists
/// them instead. The pairs are indices of bodies, the smaller first.
[[nodiscard]] std::vector<std::pair<int, int>> inseparableBodies(const deflection::Arm& arm, const Scene& scene);

}  // namespace tubeplan::planner
