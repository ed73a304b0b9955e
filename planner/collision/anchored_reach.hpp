// Reach of bodies about the rows' origins, however the rows are written: the basis of bounds on their travel.
#pragma once

#include <vector>

#include "deflection/anchored_rows.hpp"
#include "planner/scene/scene.hpp"

namespace tubeplan::planner {

struct AnchoredReach {
  deflection::Arm arm;             ///< the arm with its rows' origins near each other
  std::vector<double> body_reach;  ///< greatest distance of a body point from each row's origin there [m]
};

/// Moves the rows' origins together. `body_reach` has the same distances from the origins as written, which are kept
/// where those do not move.
[[nodiscard]] AnchoredReach anchoredReachOf(const deflection::Arm& arm, const Scene& scene,
                                            std::vector<double> body_reach);

}  // namespace tubeplan::planner
