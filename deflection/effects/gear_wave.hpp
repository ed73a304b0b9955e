// A gear with a cyclic error once per turn of its input: a wave of short period over the joint's reading.
//
// Law: true joint value = reading + A sin(N q) + B cos(N q).
// Symbols: A, B amplitudes [rad]; N gear ratio stated in the arm file (joint.gear_ratio); q reading [rad].
// Validity: readings known to a small fraction of the wave's period 2 pi / N.
// Source: kinematic error of strain wave gears: Ghorbel et al. 2001, J. Mech. Design 123:90.
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::gear_wave {

inline bool hasPlace(const Arm& arm, int row) {
  const auto& joint = arm.rows[row].joint;
  return joint.type == JointType::kRevolute && joint.gear_ratio > 0;
}

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  const int joint = jointIndexOf(context.given, effect.place.row);
  const S angle = context.nominal_posture.q[joint] * S(context.given.rows[effect.place.row].joint.gear_ratio);
  using std::cos, std::sin;
  context.posture.q[joint] += effect.values[0] * sin(angle) + effect.values[1] * cos(angle);
}

inline EffectKind kind() {
  return {
      .name = "gear-wave",
      .words = "a joint's gear has an error once per turn of the motor",
      .law = "true joint value = reading + sine * sin(ratio * reading) + cosine * cos(ratio * reading)",
      .validity = "the joint's gear_ratio is stated; readings known to a small part of a wave",
      .source = "Ghorbel et al. 2001, J. Mech. Design 123:90",
      .stage = EffectStage::kJointReading,
      .at = PlaceRule::kJoint,
      .place_needs = "a revolute joint with gear_ratio in the arm file (turns of its motor per turn of the joint)",
      .odds = 1,
      .odds_reason = "strain wave gears have an error of about an arc minute once per turn of their input",
      .varies_with = {EffectVariable::kJoint},
      .needs = {},
      .parameters = {{"sine", Quantity::kAngle, 0, -0.1, 0.1, 1e-3}, {"cosine", Quantity::kAngle, 0, -0.1, 0.1, 1e-3}},
      .places = [](const Arm& arm) { return places::ofRows(arm, hasPlace); },
      .apply = apply<double>,
      .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::gear_wave
