// Bodies of the arm that are too near each other in every posture, as drawn: a wrist's flange in the forearm's end.
#pragma once

#include <utility>
#include <vector>

#include "deflection/arm.hpp"
#include "planner/scene/scene.hpp"

namespace tubeplan::planner {

/// Of the pairs that would be judged (areJudged), those nearer than the scene's clearance at each of 1,000 postures all
/// over the joints' limits: no plan could keep them apart, so they are to be named instead (Scene::inseparable). By
/// rigid kinematics. The indices of two bodies, the first less.
[[nodiscard]] std::vector<std::pair<int, int>> inseparableBodies(const deflection::Arm& arm, const Scene& scene);

}  // namespace tubeplan::planner
