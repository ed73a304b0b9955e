// A gear ratio that differs from the nominal ratio.
//
// Law: true joint value = reading (1 + e).
// Symbols: e relative error of the ratio [1].
// Validity: readings counted from the encoder's zero; if the zero differs too, joint-offset is needed as well.
// Source: Mooring, Roth and Driels, Fundamentals of Manipulator Calibration (1991), joint transducer gains.
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::joint_scale {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  const int joint = jointIndexOf(context.given, effect.place.row);
  context.posture.q[joint] += effect.values[0] * context.nominal_posture.q[joint];
}

inline EffectKind kind() {
  return {.name = "joint-scale",
          .words = "a joint's gear ratio is off",
          .law = "true joint value = reading * (1 + scale)",
          .validity = "readings counted from the encoder's zero",
          .source = "Mooring, Roth and Driels 1991",
          .stage = EffectStage::kJointReading,
          .at = PlaceRule::kJoint,
          .odds = 0.5,
          .odds_reason = "gear ratios are exact numbers of teeth: only a wrong number or a belt gives an error",
          .varies_with = {EffectVariable::kJoint},
          .needs = {},
          .parameters = {{"scale", Quantity::kNone, 0, -0.5, 0.5, 0.01}},
          .places = places::ofJoints,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::joint_scale
