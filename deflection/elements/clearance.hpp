// Clearance about a joint axis: a gap that the joint crosses freely before it carries load.
//
// Law: complementarity. |theta| <= g/2; theta = +g/2 where the moment there is positive, -g/2 where it is negative, and
//      in between only where the moment is zero and the joint hangs freely in its gap.
// Symbols: g gap [rad], theta rotation within it [rad], M moment about the axis [N m].
// Method: theta <- clamp(theta + M/kappa, -g/2, g/2) once in each pass over the arm. kappa is at least the restoring
//      moment per angle |dM/dtheta|, times the number of clearances: the load on a joint is a pendulum, and several
//      clearances are a chain of pendulums, for which the iteration is then a contraction.
// Validity: at rest, without friction. Where the moment neither presses nor restores (an axis along gravity), theta and
//      its derivative keep their values.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace tubeplan::deflection::clearance {

/// Parameters that limit how far a joint moves within its gap in one pass.
struct Restoring {
  /// dM/dtheta if only this joint moves [N m/rad]; negative if the load hangs like a pendulum.
  double moment_per_angle;
  double scale;    ///< sum of the forces beyond the joint, times the arm's reach [N m]
  int clearances;  ///< number of clearances in the arm
};

/// Position of a joint in its gap after a pass, and the derivatives of that position.
struct GapPosition {
  double angle;          ///< position in the gap [rad]
  double by_gap = 0;     ///< derivative with respect to the gap [rad/rad]
  double by_angle = 0;   ///< derivative with respect to the angle before the pass; 1 while the joint hangs freely
  double by_moment = 0;  ///< derivative with respect to the moment [rad/(N m)]
};

inline GapPosition converge(double gap, double before, double moment, const Restoring& restoring) {
  const double half = gap / 2, side = (moment > 0) - (moment < 0), floor = 1e-6 * restoring.scale;
  // The derivative with respect to the gap does not vanish at zero: the joint moves by half of any opening.
  if (half <= 0) return {side * half, side / 2};
  const bool hangs = restoring.moment_per_angle < -floor;
  if (!hangs && std::abs(moment) <= 1e-9 * restoring.scale) return {before};
  const double kappa = std::max(
      {restoring.clearances * std::abs(restoring.moment_per_angle), floor, std::numeric_limits<double>::min()});
  const double angle = before + moment / kappa;
  if (angle > half) return {half, 0.5};
  if (angle < -half) return {-half, -0.5};
  return hangs ? GapPosition{angle, 0, 1, 1 / kappa} : GapPosition{angle};
}

}  // namespace tubeplan::deflection::clearance
