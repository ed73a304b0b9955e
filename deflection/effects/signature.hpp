// What an effect does to the tip of an arm, drawn against what it follows: a sine over a joint, two levels over its
// direction of approach, a step in time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deflection/effects/effect.hpp"

namespace tubeplan::deflection {

struct SignatureOptions {
  double most_load = 0;  ///< N, to sweep the load to and, but for that, to hang half of
  int steps = 60;        ///< between the ends of a sweep
};

struct Signature {
  std::optional<EffectVariable> kind;  ///< joint, direction, load or a condition; none: the tip does not move
  int joint = -1;                      ///< of kJoint and kDirection
  std::vector<double> at;              ///< rad, m, N, a condition's unit, or -1 and 1
  std::vector<double> shift;           ///< m, along one axis of the tool frame; NaN where the arm does not come to rest
};

/// The effect alone at half of what a real machine may have, on the arm with its other effects as they are, at one
/// posture away from its limits; each joint, each direction, load and each condition is swept in turn. The sweep
/// over which the tip's shift in the tool frame changes most is the signature, what is not a joint or is the effect's
/// own joint before others; its shift is that along the axis of the change.
[[nodiscard]] Signature signatureOf(const Arm& arm, const Effect& effect, const Eigen::Vector3d& gravity_B,
                                    const SignatureOptions& options = {});

}  // namespace tubeplan::deflection
