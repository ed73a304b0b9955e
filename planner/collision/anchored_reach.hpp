// Largest distances of body points from the origins of the arm's rows, for bounds on the travel of bodies. The origins
// are first moved along the joint axes, which makes the result independent of the origins chosen in the arm file.
#pragma once

#include <vector>

#include "deflection/anchored_rows.hpp"
#include "planner/scene/scene.hpp"

namespace tubeplan::planner {

struct AnchoredReach {
  deflection::Arm arm;  ///< the arm, with the rows' origins moved along the joint axes so that they are close together
  std::vector<double> body_reach;  ///< largest distance of a body point from the moved origin of each row [m]
};

/// Moves the rows' origins along the joint axes. `body_reach` has the largest distance [m] of a body point from each
/// row's original origin; values of rows whose origin does not move are kept.
[[nodiscard]] AnchoredReach anchoredReachOf(const deflection::Arm& arm, const Scene& scene,
                                            std::vector<double> body_reach);

}  // namespace tubeplan::planner
