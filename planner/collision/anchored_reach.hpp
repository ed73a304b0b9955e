// Distances of body points from the origins of the arm's rows, independent of where along its joint axis the arm file
// puts an origin: the basis of bounds on the travel of the bodies.
#pragma once

#include <vector>

#include "deflection/anchored_rows.hpp"
#include "planner/scene/scene.hpp"

namespace tubeplan::planner {

struct AnchoredReach {
  deflection::Arm arm;  ///< the arm, with the rows' origins moved along the joint axes so that they are near each other
  std::vector<double> body_reach;  ///< greatest distance of a body point from the moved origin of each row [m]
};

/// Moves the rows' origins along the joint axes. `body_reach` has the greatest distances from the origins as the arm
/// has them; distances of rows whose origin does not move are kept.
[[nodiscard]] AnchoredReach anchoredReachOf(const deflection::Arm& arm, const Scene& scene,
                                            std::vector<double> body_reach);

}  // namespace tubeplan::planner
