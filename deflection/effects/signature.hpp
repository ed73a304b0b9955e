// The signature of an effect: its shift of the tip of an arm, drawn against the variable that it follows. Examples are
// a sine over a joint, two levels over its direction of approach, a step in time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deflection/effects/effect.hpp"

namespace tubeplan::deflection {

struct SignatureOptions {
  double most_load = 0;  ///< largest load of a sweep [N]; other sweeps use half of it
  int steps = 60;        ///< number of steps of a sweep
};

struct Signature {
  std::optional<EffectVariable> kind;  ///< joint, direction, load or a condition; nothing: the tip does not move
  int joint = -1;                      ///< joint index for kJoint and kDirection; else -1
  std::vector<double> at;              ///< values of the variable: rad, m, N, a condition's unit, or -1 and 1
  /// Shift of the tip along one axis of the tool frame [m]; NaN where the arm has no equilibrium.
  std::vector<double> shift;
};

/// Computes the signature of an effect at half of its plausible size, on the arm with its other effects unchanged, at
/// one posture away from its limits. Each joint, each direction, the load and each condition is swept in turn. The
/// chosen sweep is the one over which the tip's shift in the tool frame changes most. Variables other than joints, and
/// the effect's own joint, come before other joints. The shift is that along the axis of the change.
[[nodiscard]] Signature signatureOf(const Arm& arm, const Effect& effect, const Eigen::Vector3d& gravity_B,
                                    const SignatureOptions& options = {});

}  // namespace tubeplan::deflection
