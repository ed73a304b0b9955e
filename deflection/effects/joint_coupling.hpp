// A joint that is also moved by another joint, through a belt or a differential.
//
// Law: true joint value = reading + share * reading of the other joint.
// Symbols: share fraction of the other joint's reading [1].
// Validity: two joints of the same type; readings counted from the encoders' zeros.
// Source: coupled joints in Craig, Introduction to Robotics (actuator space and joint space).
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::joint_coupling {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  const int to = jointIndexOf(context.given, effect.place.row);
  const int from = jointIndexOf(context.given, effect.place.other);
  context.posture.q[to] += effect.values[0] * context.nominal_posture.q[from];
}

inline EffectKind kind() {
  return {.name = "joint-coupling",
          .words = "one joint's motion turns another",
          .law = "true joint value = reading + share * reading of another joint",
          .validity = "two joints of one type",
          .source = "Craig, Introduction to Robotics: actuator and joint space",
          .stage = EffectStage::kJointReading,
          .at = PlaceRule::kJointPair,
          .odds = 0.5,
          .odds_reason = "only where drives run through other joints",
          .varies_with = {EffectVariable::kJoint},
          .needs = {},
          .parameters = {{"share", Quantity::kNone, 0, -1, 1, 0.05}},
          .places = places::ofJointPairs,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::joint_coupling
