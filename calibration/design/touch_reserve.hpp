// Which holes are still in reach when the base stands elsewhere than it is taken to: touches are there to find it.
#pragma once

#include <vector>

#include "calibration/simulation/simulated_touch.hpp"

namespace tubeplan::calibration {

/// How far off the base may stand: along any direction, and turned about any axis through its origin. As taken: three
/// sigma of what `campaign` and `score` draw.
struct BaseDoubt {
  double shift = 0.0381;  ///< m (1.5 in)
  double turn = 0.0262;   ///< rad (1.5 deg)
};

/// Those of the candidates that the arm can touch (limits and deflection; not what stands in the way) from everywhere
/// around X_WB: off by the whole doubt along and about each axis, and by as much in sum along and about all at once.
[[nodiscard]] std::vector<TouchPlan> keepTouchable(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                                   const std::vector<TouchPlan>& candidates,
                                                   const BaseDoubt& doubt = {});

/// Returns what keepTouchable() keeps, or all candidates where it keeps fewer than `count`.
[[nodiscard]] std::vector<TouchPlan> surelyTouchable(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                                     const std::vector<TouchPlan>& candidates, int count);

}  // namespace tubeplan::calibration
