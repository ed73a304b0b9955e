// Placement of the deflected tip at a given point, starting from a nearby posture, with the tool in any orientation.
#pragma once

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::calibration {

struct TipPlacementOptions {
  double tolerance = 1e-11;  ///< largest distance of the tip from the goal [m]
  int max_iterations = 60;
  /// Smallest accepted singular value of the tip's Jacobian [m/rad], divided by the arm's reach; below it the status is
  /// kStretched.
  double singular_floor = 0.01;
};

enum class TipPlacementStatus { kNotRun, kPlaced, kNotConverged, kStretched };

struct TipPlacement {
  TipPlacementStatus status = TipPlacementStatus::kNotRun;
  Eigen::VectorXd q;  ///< joint readings of the posture reached
};

/// Moves the tip to `p_BT` [m] by Broyden's method on the tip's three coordinates, with the smallest joint motion from
/// the joint readings of `start`. The first Jacobian treats the deflected shape as rigid, which is accurate to a few
/// per cent and much faster than exact derivatives. Joint limits are ignored. The status is kStretched if the tip can
/// hardly move in some direction at the posture reached.
[[nodiscard]] TipPlacement placeTip(const deflection::Arm& arm, const deflection::Posture& start,
                                    const Eigen::Vector3d& p_BT, const TipPlacementOptions& options = {});

}  // namespace tubeplan::calibration
