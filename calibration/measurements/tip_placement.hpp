// Bringing the deflected tip to a place from a posture nearby, whatever way the tool then points.
#pragma once

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::calibration {

struct TipPlacementOptions {
  double tolerance = 1e-11;  ///< m
  int max_iterations = 60;
  double singular_floor = 0.01;  ///< least singular value of the tip's motion per reach and rad
};

enum class TipPlacementStatus { kNotRun, kPlaced, kNotConverged, kStretched };

struct TipPlacement {
  TipPlacementStatus status = TipPlacementStatus::kNotRun;
  Eigen::VectorXd q;  ///< joint readings
};

/// Broyden's method on the three coordinates alone, with the smallest joint motion, from the posture's own readings. It
/// starts with the Jacobian of the deflected shape taken as rigid, which is right but for a few per cent and far
/// quicker than exact derivatives. Limits are not looked at. Stretched: the arm there can hardly move in some
/// direction.
[[nodiscard]] TipPlacement placeTip(const deflection::Arm& arm, const deflection::Posture& start,
                                    const Eigen::Vector3d& p_BT, const TipPlacementOptions& options = {});

}  // namespace tubeplan::calibration
