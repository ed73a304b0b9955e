// An offset of a joint's zero.
//
// Law: true joint value = reading + d.
// Symbols: d offset [rad; m for a prismatic joint].
// Validity: the same for every reading.
// Source: Craig, Introduction to Robotics; the first of the geometric errors in Klimchik et al. (arXiv 1211.5739).
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::joint_offset {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  context.posture.q[jointIndexOf(context.given, effect.place.row)] += effect.values[0];
}

inline EffectKind kind() {
  return {
      .name = "joint-offset",
      .words = "a joint's zero is off",
      .law = "true joint value = reading + offset",
      .validity = "the same for every reading",
      .source = "Klimchik et al., arXiv 1211.5739",
      .stage = EffectStage::kJointReading,
      .at = PlaceRule::kJoint,
      .odds = 2,
      .odds_reason =
          "homing and drawing errors of joints are the commonest geometric error (Klimchik et al., arXiv 1211.5739)",
      .varies_with = {EffectVariable::kJoint},
      .needs = {},
      .parameters = {{"offset", Quantity::kAngle, 0, -3.2, 3.2, 0.035}},
      .places = places::ofJoints,
      .apply = apply<double>,
      .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::joint_offset
