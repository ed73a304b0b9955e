// Holes that are in reach from every likely position of the base, whose touches are to find it.
#pragma once

#include <vector>

#include "calibration/simulation/simulated_touch.hpp"

namespace tubeplan::calibration {

/// Largest error of the base: along any direction, and in rotation about any axis through its origin. The defaults are
/// three sigma of the errors that `campaign` and `score` draw.
struct BaseDoubt {
  double shift = 0.0381;  ///< [m] (1.5 in)
  double turn = 0.0262;   ///< [rad] (1.5 deg)
};

/// Returns the candidates that the arm can touch (limits and deflection, without collisions) from everywhere around
/// X_WB: with the whole error along and about each axis, and with the same sum along and about all axes together.
[[nodiscard]] std::vector<TouchPlan> keepTouchable(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                                   const std::vector<TouchPlan>& candidates,
                                                   const BaseDoubt& doubt = {});

/// Returns the candidates that keepTouchable() keeps, or all candidates if it keeps fewer than `count`.
[[nodiscard]] std::vector<TouchPlan> surelyTouchable(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                                     const std::vector<TouchPlan>& candidates, int count);

}  // namespace tubeplan::calibration
