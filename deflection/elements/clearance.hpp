// Clearance in a joint axis: a gap that the load crosses freely before the joint carries it.
//
// Law: complementarity. |theta| <= g/2; theta = +g/2 where the moment is positive there, -g/2 where it is negative, and
//      in between only where the moment is zero, the joint hanging freely in its gap.
// Symbols: g gap [rad], theta rotation within it [rad], M moment about the axis [N m].
// Method: theta <- clamp(theta + M/kappa, -g/2, g/2) once in each pass of the shape, kappa at least the restoring
//      moment per angle, |dM/dtheta|: what hangs on the joint is a pendulum, and with several clearances a chain of
//      them, whose iteration is a contraction when each kappa counts them all.
// Validity: at rest, without friction. Where the moment neither presses nor restores (an axis along gravity) theta stays
//      as it is, and so does its derivative.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "deflection/scalar.hpp"

namespace tubeplan::deflection::clearance {

/// What decides how far a pass may move a joint within its gap.
struct Restoring {
  double moment_per_angle;  ///< dM/dtheta of the joint turned alone [N m/rad]; negative: the load hangs
  double scale;             ///< all forces beyond times the arm's reach [N m]
  int clearances;           ///< how many there are in the arm
};

template <class S>
S settle(const S& gap, const S& before, const S& moment, const Restoring& restoring) {
  const S half = gap / 2.;
  const double m = valueOf(moment), floor = 1e-6 * restoring.scale;
  // A closed gap still has its derivative: half of what it would open, in the sense of the moment.
  if (valueOf(half) <= 0) return half * static_cast<double>((m > 0) - (m < 0));
  const bool hangs = restoring.moment_per_angle < -floor;
  if (!hangs && std::abs(m) <= 1e-9 * restoring.scale) return before;
  const double kappa = std::max({restoring.clearances * std::abs(restoring.moment_per_angle), floor,
                                 std::numeric_limits<double>::min()});
  const S rest = before + moment / kappa;
  if (rest > half) return half;
  if (rest < -half) return -half;
  return hangs ? rest : S(valueOf(rest));
}

}  // namespace tubeplan::deflection::clearance
