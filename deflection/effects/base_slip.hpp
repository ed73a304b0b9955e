// A base that slips once.
//
// Law: after the slip time, the base is shifted by (x, y, z) and rotated by yaw about its own z axis.
// Symbols: x, y, z [m] in the axes of the base before the slip, yaw [rad], t slip time [s].
// Validity: a single slip. A measurement without a time is treated as taken after the slip.
// Source: rigid body.
#pragma once

#include "deflection/effects/places.hpp"

namespace tubeplan::deflection::base_slip {

template <class S>
void apply(const EffectOf<S>& effect, EffectContext<S>& context) {
  if (context.nominal_posture.conditions[Condition::kTime] < valueOf(effect.values[4])) return;
  for (int k = 0; k < 3; ++k) context.X_BM.p[k] += effect.values[k];
  context.X_BM.R = context.X_BM.R * rotationZ<S>(effect.values[3]);
}

inline EffectKind kind() {
  return {.name = "base-slip",
          .words = "the base slipped once",
          .law = "after a given time the base is shifted by (x, y, z) and rotated by yaw about its z axis",
          .validity = "one step",
          .source = "rigid body",
          .stage = EffectStage::kBase,
          .at = PlaceRule::kWord,
          .word = "base",
          .odds = 1,
          .odds_reason = "clamps yield once",
          .varies_with = {Condition::kTime},
          .needs = {},
          .parameters = {{"x", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.02},
                         {"y", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.02},
                         {"z", Quantity::kLength, 0, -kUnbounded, kUnbounded, 0.02},
                         {"yaw", Quantity::kAngle, 0, -3.2, 3.2, 0.02},
                         {"time", Quantity::kTime, 0, -kUnbounded, kUnbounded, kUnbounded, true}},
          .places = places::singlePlace,
          .apply = apply<double>,
          .applyDual = apply<Dual>};
}

}  // namespace tubeplan::deflection::base_slip
