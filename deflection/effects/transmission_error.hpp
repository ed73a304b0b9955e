// A gear with an error of two periods per turn of the joint, due for example to an oval ring or an elliptic bearing.
//
// Law: true joint angle = reading + A sin(2 q) + B cos(2 q).
// Symbols: q reading [rad], A, B amplitudes [rad].
// Validity: amplitudes far below one radian; revolute joints only; the purely kinematic error.
// Source: Ghorbel, Gandhi and Alpeter, On the kinematic error in harmonic drive gears (J. Mech. Des. 123, 2001).
#pragma once

#include <cmath>

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::transmission_error {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  using std::cos, std::sin;
  const int joint = jointIndexOf(context.given, effect.place.row);
  const S twice = context.nominal_posture.q[joint] * 2.;
  context.posture.q[joint] += effect.values[0] * sin(twice) + effect.values[1] * cos(twice);
}

inline EffectKind kind() {
  return {.name = "transmission-error",
          .words = "a joint's gear has an error twice per turn",
          .law = "true joint angle = reading + sine * sin(2 reading) + cosine * cos(2 reading)",
          .validity = "amplitudes far below a radian; turning joints",
          .source = "Ghorbel, Gandhi and Alpeter 2001",
          .stage = EffectStage::kJointReading,
          .at = PlaceRule::kJoint,
          .odds = 1,
          .odds_reason = "an oval ring or an elliptic bearing has an error twice per turn of the joint",
          .varies_with = {EffectVariable::kJoint},
          .needs = {},
          .parameters = {{"sine", Quantity::kAngle, 0, -0.5, 0.5, 0.005},
                         {"cosine", Quantity::kAngle, 0, -0.5, 0.5, 0.005}},
          .places = places::ofRevoluteJoints,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::transmission_error
