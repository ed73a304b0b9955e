// Where bodies are about the rows' origins, wherever these were written: what bounds of their travel start from.
#pragma once

#include <vector>

#include "deflection/anchored_rows.hpp"
#include "planner/scene/scene.hpp"

namespace tubeplan::planner {

struct AnchoredReach {
  deflection::Arm arm;             ///< its rows' origins near each other
  std::vector<double> body_reach;  ///< m, by rows: greatest distance of a body point from the row's origin there
};

/// `body_reach`: the same from the origins as they are written, where those stay.
[[nodiscard]] AnchoredReach anchoredReachOf(const deflection::Arm& arm, const Scene& scene,
                                            std::vector<double> body_reach);

}  // namespace tubeplan::planner
