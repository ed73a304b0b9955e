// Selection of the holes that the arm can touch from every likely base pose, for use before touches have determined the
// pose.
#pragma once

#include <vector>

#include "calibration/simulation/simulated_touch.hpp"

namespace tubeplan::calibration {

/// Largest expected error of the base pose: shift in any direction, and rotation about any axis through the base's
/// origin. The defaults are three standard deviations of the base errors that the commands `campaign` and `score`
/// simulate.
struct BaseUncertainty {
  double shift = 0.0381;  ///< largest shift [m] (1.5 in)
  double turn = 0.0262;   ///< largest rotation [rad] (1.5 deg)
};

/// Returns the candidates that the arm can touch from every base displaced from X_WB by the largest error along or
/// about one axis, or by an error of the same relative size spread over all axes. Joint limits and deflection are
/// considered, collisions are not.
[[nodiscard]] std::vector<TouchPlan> keepTouchable(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                                   const std::vector<TouchPlan>& candidates,
                                                   const BaseUncertainty& uncertainty = {});

/// Returns the result of keepTouchable(), or all candidates if it has fewer than `count` entries.
[[nodiscard]] std::vector<TouchPlan> robustlyTouchable(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                                                       const std::vector<TouchPlan>& candidates, int count);

}  // namespace tubeplan::calibration
