// Signature of an effect: the tip shift that it causes, as a function of the variable on which it depends. Examples are
// a sine over a joint angle, two levels for the two directions of approach, and a step in time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deflection/effects/effect.hpp"

namespace tubeplan::deflection {

struct SignatureOptions {
  double most_load = 0;  ///< largest load in a load sweep [N]; other sweeps use half of it
  int steps = 60;        ///< number of steps of a sweep
};

struct Signature {
  /// Joint, direction, load or a condition; empty means that the tip does not move.
  std::optional<EffectVariable> kind;
  int joint = -1;          ///< joint index for kJoint and kDirection, otherwise -1
  std::vector<double> at;  ///< values of the variable [rad, m, N, condition unit]; -1 and 1 for a direction
  /// Shift of the tip along a fixed direction in the last row's axes [m]; NaN where the arm has no equilibrium.
  std::vector<double> shift;
};

/// Computes the signature of an effect at half of its plausible magnitude, at one posture away from the joint limits;
/// the arm's other effects are unchanged. Each joint, each direction, the load and each condition is swept in turn. The
/// chosen sweep is the one over which the tip's shift in the last row's axes changes most; conditions, directions and
/// the effect's own joint are weighted more than other joints and the load. The reported shift is the component along
/// the axis of that change.
[[nodiscard]] Signature signatureOf(const Arm& arm, const Effect& effect, const Eigen::Vector3d& gravity_B,
                                    const SignatureOptions& options = {});

}  // namespace tubeplan::deflection
