// An encoder disc off its axis: an error with a period of one turn.
//
// Law: true joint angle = reading + A sin(q) + B cos(q).
// Symbols: q reading [rad], A, B amplitudes [rad], approximately eccentricity divided by disc radius.
// Validity: amplitudes far below one radian; revolute joints only.
// Source: the centring errors of telescope pointing (Wallace, TPOINT: HCES, HCEC, DCES, DCEC).
#pragma once

#include <cmath>

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::encoder_eccentricity {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  using std::cos, std::sin;
  const int joint = jointIndexOf(context.given, effect.place.row);
  const S& q = context.nominal_posture.q[joint];
  context.posture.q[joint] += effect.values[0] * sin(q) + effect.values[1] * cos(q);
}

inline EffectKind kind() {
  return {
      .name = "encoder-eccentricity",
      .words = "a joint's encoder disc is eccentric: an error once per turn",
      .law = "true joint angle = reading + sine * sin(reading) + cosine * cos(reading)",
      .validity = "amplitudes far below a radian; turning joints",
      .source = "Wallace, TPOINT: centring errors",
      .stage = EffectStage::kJointReading,
      .at = PlaceRule::kJoint,
      .odds = 1,
      .odds_reason = "every code disc is off centre by some micrometres",
      .varies_with = {EffectVariable::kJoint},
      .needs = {},
      .parameters = {{"sine", Quantity::kAngle, 0, -0.5, 0.5, 0.01}, {"cosine", Quantity::kAngle, 0, -0.5, 0.5, 0.01}},
      .places = places::ofRevoluteJoints,
      .apply = apply<double>,
      .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::encoder_eccentricity
