// Placement of the deflected tip at a point from a posture nearby, with the tool in any direction.
#pragma once

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::calibration {

struct TipPlacementOptions {
  double tolerance = 1e-11;  ///< [m]
  int max_iterations = 60;
  double singular_floor = 0.01;  ///< least singular value of the tip's motion per reach and rad
};

enum class TipPlacementStatus { kNotRun, kPlaced, kNotConverged, kStretched };

struct TipPlacement {
  TipPlacementStatus status = TipPlacementStatus::kNotRun;
  Eigen::VectorXd q;  ///< joint readings
};

/// Moves the tip to `p_BT` [m] by Broyden's method on its three coordinates, with the smallest joint motion, from the
/// readings of `start`. The first Jacobian is that of the deflected shape taken as rigid, which is right within a few
/// per cent and far quicker than exact derivatives. Joint limits are ignored. kStretched: the arm can hardly move in
/// some direction there.
[[nodiscard]] TipPlacement placeTip(const deflection::Arm& arm, const deflection::Posture& start,
                                    const Eigen::Vector3d& p_BT, const TipPlacementOptions& options = {});

}  // namespace tubeplan::calibration
